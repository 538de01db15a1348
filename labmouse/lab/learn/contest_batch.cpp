#include "labmouse/lab/learn/contest_batch.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "labmouse/contest/score.hpp"

namespace labmouse {
namespace {

// Effect of each choice. Turn and direction are in quarter turns clockwise from the heading before the step.
struct Effect {
  std::uint8_t turn = 0;
  std::uint8_t direction = 0;
  std::uint8_t cells = 0;
};

constexpr auto moves = [] {
  std::array<Effect, choice_count> table;
  for (int choice = 0; choice < reset_choice; ++choice) {
    const int turn = choice / choices_a_turn - 1;
    const int movement = choice % choices_a_turn - longest_choice;
    table[static_cast<unsigned>(choice)] = {static_cast<std::uint8_t>(turn & 3),
                                            static_cast<std::uint8_t>((movement < 0 ? turn + 2 : turn) & 3),
                                            static_cast<std::uint8_t>(movement < 0 ? -movement : movement)};
  }
  return table;
}();

// Number of contests ahead of which memory is prefetched; enough to hide the latency.
constexpr std::size_t fetched_ahead = 6;

Size largest_of(std::span<const Maze> mazes) {
  Size size{1, 1};
  for (const Maze& maze : mazes)
    size = {std::max(size.width, maze.size().width), std::max(size.height, maze.size().height)};
  return size;
}

}  // namespace

double search_reward(const Rules& rules) {
  constexpr double grain = 1LL << 40;
  return -std::round(grain / rules.search_factor) / grain;
}

ContestBatch::ContestBatch(int count, Size size, std::size_t slots, MazeOrder order, const Rules& rules)
    : rules_(rules),
      search_reward_(search_reward(rules)),
      size_(size),
      order_(order),
      contests_(static_cast<std::size_t>(count)) {
  assert(count >= 1 && rules.stride == longest_choice && rules.budget >= 1);
  assert(rules.budget <= std::numeric_limits<std::int16_t>::max());
  tables_.resize(slots * area());
  facts_.resize(slots);
  for (int i = 0; i < count; ++i) seed(i, static_cast<std::uint64_t>(i));
}

ContestBatch::ContestBatch(int count, std::span<const Maze> mazes, MazeOrder order, const Rules& rules)
    : ContestBatch(count, largest_of(mazes), mazes.size(), order, rules) {
  listed_ = true;
  maze_count_ = mazes.size();
  for (std::size_t slot = 0; slot < mazes.size(); ++slot) set_slot(slot, mazes[slot]);
}

ContestBatch::ContestBatch(int count, const MazeFamily& family, MazeOrder order, const Rules& rules)
    : ContestBatch(count, family.size, static_cast<std::size_t>(count), order, rules) {
  family_ = family;
  maze_count_ = family.count;
  for (std::size_t i = 0; i < contests_.size(); ++i) contests_[i].slot = static_cast<std::uint32_t>(i);
}

std::size_t ContestBatch::bytes_a_contest() const {
  return sizeof(Contest) + (listed_ ? 0 : area() * sizeof(Corridors) + sizeof(Facts));
}

void ContestBatch::bind(const BatchMemory& memory) {
  assert(memory.words.empty() || memory.bytes.empty());
  assert(memory.returns.size() == contests_.size() && memory.ended.size() == contests_.size());
  memory_ = memory;
}

void ContestBatch::seed(int contest, std::uint64_t seed) {
  Contest& seeded = contests_[static_cast<std::size_t>(contest)];
  seeded.rng = Rng(seed_for(seed, "contests"));
  seeded.played = 0;
}

void ContestBatch::set_slot(std::size_t slot, const Maze& maze) {
  write_corridors(maze, size_.width, std::span(tables_).subspan(slot * area(), area()));
  const auto number = [](int value) { return static_cast<std::int16_t>(value); };
  Facts& facts = facts_[slot];
  facts = {number(maze.size().width),
           number(maze.size().height),
           maze.start().x,
           maze.start().y,
           number(static_cast<int>(maze.start_heading())),
           max_side,
           max_side,
           0,
           0};
  maze.goals().for_each([&](Cell cell) {
    facts.goal_west = std::min<std::int16_t>(facts.goal_west, cell.x);
    facts.goal_south = std::min<std::int16_t>(facts.goal_south, cell.y);
    facts.goal_east = std::max<std::int16_t>(facts.goal_east, cell.x);
    facts.goal_north = std::max<std::int16_t>(facts.goal_north, cell.y);
  });
}

std::uint64_t ContestBatch::next_maze(std::size_t contest) {
  Contest& next = contests_[contest];
  const std::uint64_t turn = contest + next.played++ * contests_.size();
  if (order_ == MazeOrder::in_turn) return maze_count_ == 0 ? turn : turn % maze_count_;
  // 63 bits, so that the number fits into a signed 64-bit integer.
  const std::uint64_t drawn = next.rng.bits() >> 1U;
  return maze_count_ == 0 ? drawn : drawn % maze_count_;
}

void ContestBatch::begin(std::size_t contest, const Stop& stop) {
  Contest& begun = contests_[contest];
  if (!listed_ && stop && stop()) {
    begun.ended = true;
    memory_.ended[contest] = 1;
    return;
  }
  const std::uint64_t number = next_maze(contest);
  if (listed_)
    begun.slot = static_cast<std::uint32_t>(number);
  else
    set_slot(begun.slot, maze_of(family_, number));
  const Facts& facts = facts_[begun.slot];
  begun.x = static_cast<std::uint8_t>(facts.start_x);
  begun.y = static_cast<std::uint8_t>(facts.start_y);
  begun.heading = static_cast<std::uint8_t>(facts.start_heading);
  begun.clock = begun.explored = 0;
  begun.moved = 0;
  begun.blocked = begun.speed_run = begun.goal_entered = begun.ended = false;
  memory_.returns[contest] = 0.0;
  memory_.ended[contest] = 0;
  if (!memory_.rewards.empty()) memory_.rewards[contest] = 0.0;
  if (!memory_.states.empty()) memory_.states[contest] = static_cast<std::uint8_t>(ContestState::running);
  if (!memory_.maze_numbers.empty()) memory_.maze_numbers[contest] = static_cast<std::int64_t>(number);
  if (!memory_.rows.empty()) {
    const std::array<std::int16_t, 6> told = {facts.width,      facts.height,    facts.goal_west,
                                              facts.goal_south, facts.goal_east, facts.goal_north};
    std::copy(
        told.begin(), told.end(),
        memory_.rows.begin() + static_cast<std::ptrdiff_t>(contest) * row_columns + static_cast<int>(RowColumn::width));
  }
  with_belief(contest, [&]<class Form>(Form, typename Form::Unit* cells) { begin_belief<Form>(begun, cells); });
  observe(contest);
}

void ContestBatch::start(const Stop& stop) {
  for (std::size_t i = 0; i < contests_.size(); ++i) begin(i, stop);
}

void ContestBatch::start(std::span<const std::uint8_t> which, const Stop& stop) {
  assert(which.size() == contests_.size());
  for (std::size_t i = 0; i < contests_.size(); ++i)
    if (which[i] != 0) begin(i, stop);
}

bool ContestBatch::step(std::span<const std::int64_t> choices, const Stop& stop) {
  assert(choices.size() == contests_.size());
  const bool in_range = std::all_of(choices.begin(), choices.end(), [](std::int64_t choice) {
    return static_cast<std::uint64_t>(choice) < static_cast<std::uint64_t>(choice_count);
  });
  if (!in_range) return false;
  for (std::size_t i = 0; i < contests_.size(); ++i) {
    if (i + fetched_ahead < contests_.size()) prefetch(i + fetched_ahead);
    if (contests_[i].ended)
      begin(i, stop);
    else
      play(i, static_cast<int>(choices[i]));
  }
  return true;
}

void ContestBatch::play(std::size_t contest, int choice) {
  Contest& played = contests_[contest];
  const Contest before = played;
  ++played.clock;
  if (!before.speed_run) ++played.explored;
  move(played, choice);
  settle(contest, choice, before.speed_run);
  with_belief(contest,
              [&]<class Form>(Form, typename Form::Unit* cells) { change_belief<Form>(played, before, cells); });
  observe(contest);
}

void ContestBatch::move(Contest& contest, int choice) const {
  contest.moved = 0;
  contest.blocked = false;
  if (choice == reset_choice) {
    if (contest.speed_run || !contest.goal_entered) return;
    const Facts& facts = facts_[contest.slot];
    contest.speed_run = true;
    contest.x = static_cast<std::uint8_t>(facts.start_x);
    contest.y = static_cast<std::uint8_t>(facts.start_y);
    contest.heading = static_cast<std::uint8_t>(facts.start_heading);
    return;
  }
  const Effect& asked = moves[static_cast<unsigned>(choice)];
  contest.direction = (contest.heading + asked.direction) & 3U;
  contest.heading = (contest.heading + asked.turn) & 3U;
  const int open = corridor(corridors(contest), static_cast<Heading>(contest.direction));
  const int cells = std::min<int>(asked.cells, open);
  contest.moved = static_cast<std::uint8_t>(cells);
  contest.blocked = asked.cells > open;
  contest.x = static_cast<std::uint8_t>(contest.x + steps_east[contest.direction] * cells);
  contest.y = static_cast<std::uint8_t>(contest.y + steps_north[contest.direction] * cells);
}

// Sets the reward of the step, and ends the contest if it was the last.
void ContestBatch::settle(std::size_t contest, int choice, bool in_speed_run) {
  Contest& settled = contests_[contest];
  // After a reset the mouse may be in a goal, if the start is one; but no step ended there.
  const bool at_goal = choice != reset_choice && is_goal(corridors(settled));
  ContestState state = ContestState::running;
  if (at_goal && in_speed_run)
    state = ContestState::finished;
  else if (settled.clock == rules_.budget)
    state = settled.speed_run                 ? ContestState::speed_run_unfinished
            : settled.goal_entered || at_goal ? ContestState::never_reset
                                              : ContestState::out_of_steps;
  settled.goal_entered = settled.goal_entered || at_goal;
  settled.ended = state != ContestState::running;
  double& sum = memory_.returns[contest];
  double reward = in_speed_run ? -1.0 : search_reward_;
  if (state == ContestState::finished)
    reward = -score_of(settled.explored, settled.clock - settled.explored, rules_) - sum;
  else if (settled.ended)
    reward = -rules_.failure_score - sum;
  sum += reward;
  memory_.ended[contest] = settled.ended ? 1 : 0;
  if (!memory_.rewards.empty()) memory_.rewards[contest] = reward;
  if (!memory_.states.empty()) memory_.states[contest] = static_cast<std::uint8_t>(state);
}

void ContestBatch::observe(std::size_t contest) {
  Contest& seeing = contests_[contest];
  const Sighting seen = sighting_of(corridors(seeing), static_cast<Heading>(seeing.heading));
  seeing.choice_case = static_cast<std::uint8_t>(choice_case(seen, seeing.goal_entered && !seeing.speed_run));
  if (!memory_.masks.empty()) {
    const auto& mask = valid_choices_of_cases[seeing.choice_case].mask;
    std::copy(mask.begin(), mask.end(), memory_.masks.begin() + static_cast<std::ptrdiff_t>(contest) * choice_count);
  }
  if (!memory_.rows.empty()) write_row(contest, seen);
  with_belief(contest, [&]<class Form>(Form, typename Form::Unit* cells) { see<Form>(seeing, cells); });
}

void ContestBatch::write_row(std::size_t contest, Sighting seen) {
  const Contest& shown = contests_[contest];
  const auto number = [](int value) { return static_cast<std::int16_t>(value); };
  const std::array<std::int16_t, 10> row = {number(seen.left),
                                            number(seen.ahead),
                                            number(seen.right),
                                            shown.x,
                                            shown.y,
                                            shown.heading,
                                            shown.speed_run,
                                            shown.goal_entered,
                                            number(rules_.budget - shown.clock),
                                            shown.blocked};
  std::copy(row.begin(), row.end(), memory_.rows.begin() + static_cast<std::ptrdiff_t>(contest) * row_columns);
}

template <class Write>
void ContestBatch::with_belief(std::size_t contest, Write write) {
  if (!memory_.words.empty())
    write(BeliefWord{}, &memory_.words[contest * area()]);
  else if (!memory_.bytes.empty())
    write(BeliefBytes{}, &memory_.bytes[contest * area() * BeliefBytes::units_a_cell]);
}

template <class Form>
void ContestBatch::begin_belief(const Contest& contest, typename Form::Unit* cells) const {
  std::fill_n(cells, area() * Form::units_a_cell, typename Form::Unit{0});
  const Facts& facts = facts_[contest.slot];
  const Corridors* table = &tables_[contest.slot * area()];
  for (int y = 0; y < facts.height; ++y)
    for (int x = 0; x < facts.width; ++x) {
      BeliefBits bits = 0;
      if (y == facts.height - 1) bits |= closed_bit(Heading::north);
      if (x == facts.width - 1) bits |= closed_bit(Heading::east);
      if (y == 0) bits |= closed_bit(Heading::south);
      if (x == 0) bits |= closed_bit(Heading::west);
      const auto cell = static_cast<std::size_t>(y * size_.width + x);
      if (is_goal(table[cell])) bits |= goal_bit;
      if (bits != 0) Form::add(cells + cell * Form::units_a_cell, bits);
    }
  Form::add(cells + place(contest) * Form::units_a_cell, visited_bit | pose_bit(static_cast<Heading>(contest.heading)));
}

template <class Form>
void ContestBatch::change_belief(const Contest& contest, const Contest& before, typename Form::Unit* cells) const {
  Form::remove(cells + place(before) * Form::units_a_cell, pose_bit(static_cast<Heading>(before.heading)));
  // Backwards from its present cell over the cells that it passed.
  const std::ptrdiff_t a_cell = (steps_east[contest.direction] + steps_north[contest.direction] * size_.width) *
                                static_cast<std::ptrdiff_t>(Form::units_a_cell);
  auto* const here = cells + place(contest) * Form::units_a_cell;
  Form::add(here, visited_bit | pose_bit(static_cast<Heading>(contest.heading)));
  for (int back = 1; back < contest.moved; ++back) Form::add(here - back * a_cell, visited_bit);
  if (contest.goal_entered != before.goal_entered) add_everywhere<Form>(contest, goal_entered_bit, cells);
  if (contest.speed_run != before.speed_run) add_everywhere<Form>(contest, speed_run_bit, cells);
}

template <class Form>
void ContestBatch::add_everywhere(const Contest& contest, BeliefBits bits, typename Form::Unit* cells) const {
  const Facts& facts = facts_[contest.slot];
  for (int y = 0; y < facts.height; ++y)
    for (int x = 0; x < facts.width; ++x)
      Form::add(cells + static_cast<std::size_t>(y * size_.width + x) * Form::units_a_cell, bits);
}

// Marks what is seen, as Knowledge::learn does: each open wall of a corridor and the closed one at its end, in both of
// its cells.
template <class Form>
void ContestBatch::see(const Contest& contest, typename Form::Unit* cells) const {
  const Facts& facts = facts_[contest.slot];
  const Corridors open = corridors(contest);
  auto* const here = cells + place(contest) * Form::units_a_cell;
  for (const int quarters : {-1, 0, 1}) {
    const Heading side = turned(static_cast<Heading>(contest.heading), quarters);
    const auto index = static_cast<unsigned>(side);
    const std::ptrdiff_t a_cell =
        (steps_east[index] + steps_north[index] * size_.width) * static_cast<std::ptrdiff_t>(Form::units_a_cell);
    const int length = corridor(open, side);
    auto* cell = here;
    BeliefBits entered = 0;
    for (int passed = 0; passed < length; ++passed, cell += a_cell) {
      Form::add(cell, entered | open_bit(side));
      entered = open_bit(opposite(side));
    }
    Form::add(cell, entered | closed_bit(side));
    const int beyond_x = contest.x + steps_east[index] * (length + 1),
              beyond_y = contest.y + steps_north[index] * (length + 1);
    if (beyond_x >= 0 && beyond_y >= 0 && beyond_x < facts.width && beyond_y < facts.height)
      Form::add(cell + a_cell, closed_bit(opposite(side)));
  }
}

void ContestBatch::prefetch(std::size_t contest) const {
  const Contest& next = contests_[contest];
  const std::size_t cell = place(next);
  __builtin_prefetch(&tables_[next.slot * area() + cell]);
  if (!memory_.words.empty()) __builtin_prefetch(&memory_.words[contest * area() + cell], 1);
  if (!memory_.bytes.empty())
    __builtin_prefetch(&memory_.bytes[(contest * area() + cell) * BeliefBytes::units_a_cell], 1);
}

void ContestBatch::draw_valid_choices(Rng& rng, std::span<std::int64_t> choices) const {
  assert(choices.size() == contests_.size());
  for (std::size_t i = 0; i < contests_.size(); ++i) {
    const ValidChoices& valid = valid_choices_of_cases[contests_[i].choice_case];
    const std::uint64_t drawn = (rng.bits() >> 32U) * static_cast<std::uint64_t>(valid.count) >> 32U;
    choices[i] = valid.list[drawn];
  }
}

}  // namespace labmouse
