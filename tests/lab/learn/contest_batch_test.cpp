#include "labmouse/lab/learn/contest_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/learn/maze_family.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

/// A batch with memory for all that it writes; the belief as words or as bytes.
struct Played {
  ContestBatch batch;
  std::size_t n;
  std::vector<std::int16_t> rows;
  std::vector<std::uint16_t> words;
  std::vector<std::uint8_t> bytes;
  std::vector<std::int8_t> masks;
  std::vector<double> rewards, returns;
  std::vector<std::uint8_t> ended, states;
  std::vector<std::int64_t> numbers, choices;

  Played(ContestBatch made, bool as_bytes) : batch(std::move(made)), n(static_cast<std::size_t>(batch.count())) {
    const std::size_t area = static_cast<std::size_t>(batch.size().area());
    rows.resize(n * row_columns);
    (as_bytes ? bytes.resize(n * area * belief_planes) : words.resize(n * area));
    masks.resize(n * choice_count);
    rewards.resize(n), returns.resize(n), ended.resize(n), states.resize(n), numbers.resize(n), choices.resize(n);
    batch.bind({rows, words, bytes, masks, rewards, returns, ended, states, numbers});
    batch.start();
  }

  int row(std::size_t contest, RowColumn column) const {
    return rows[contest * row_columns + static_cast<unsigned>(column)];
  }
  BeliefBits bits(std::size_t contest, Cell cell) const {
    const Size size = batch.size();
    const std::size_t at = contest * static_cast<std::size_t>(size.area()) + static_cast<std::size_t>(size.index(cell));
    if (!words.empty()) return words[at];
    unsigned packed = 0;
    for (unsigned bit = 0; bit < belief_planes; ++bit) packed |= unsigned{bytes[at * belief_planes + bit]} << bit;
    return static_cast<BeliefBits>(packed);
  }
};

Maze random_maze(Rng& rng) {
  for (;;) {
    const auto generators = all_generators();
    const Generator& generator = *generators[static_cast<std::size_t>(rng.below(static_cast<int>(generators.size())))];
    const int side = rng.chance(1, 8) ? 12 : 0;
    const GeneratorOrder order{
        {side != 0 ? side : 1 + rng.below(7), side != 0 ? side : 1 + rng.below(7)}, rng.bits(), rng.below(1001)};
    if (!generator.refuses(order).empty()) continue;
    CellSet goals;
    for (int goal = 0, count = 1 + rng.below(3); goal < count; ++goal)
      goals.insert(order.size.cell_at(rng.below(order.size.area())));
    return generator.make(order)
        .with_start(order.size.cell_at(rng.below(order.size.area())), all_headings[static_cast<unsigned>(rng.below(4))])
        .with_goals(goals);
  }
}

/// What one contest's mouse knows, kept plainly: by Knowledge and a set of cells.
struct PlainBelief {
  Knowledge knowledge;
  CellSet visited;

  explicit PlainBelief(const Maze& maze) : knowledge(maze.size()), visited(CellSet::of(maze.start())) {}

  BeliefBits bits(const Maze& maze, Cell cell, Pose pose, bool speed_run, bool goal_entered) const {
    unsigned bits = 0;
    for (const Heading side : all_headings) {
      const WallState state = knowledge.state(wall_at(cell, side));
      if (state == WallState::open) bits |= open_bit(side);
      if (state == WallState::closed) bits |= closed_bit(side);
    }
    if (visited.contains(cell)) bits |= visited_bit;
    if (pose.cell == cell) bits |= pose_bit(pose.heading);
    if (maze.is_goal(cell)) bits |= goal_bit;
    if (speed_run) bits |= speed_run_bit;
    if (goal_entered) bits |= goal_entered_bit;
    return static_cast<BeliefBits>(bits);
  }
};

/// Follows one contest of the batch: its choices so far, and what its mouse should know.
struct Follower {
  Maze maze;
  PlainBelief belief;
  std::vector<Action> actions;
  double sum = 0.0;

  explicit Follower(const Maze& played) : maze(played), belief(played) {}
};

/// The record of the choices so far; then a script without more actions forfeits, in the pose that it came to.
RunRecord replay(const Follower& follower, const Rules& rules) {
  Script mouse(follower.maze.size(), follower.actions);
  return run(follower.maze, rules, mouse);
}

/// Compares all that the batch shows of a contest that has not ended with the simulator.
void expect_shown(const Played& played, std::size_t i, Follower& follower, const Rules& rules) {
  const RunRecord record = replay(follower, rules);
  ASSERT_EQ(record.outcome, Outcome::forfeit);
  const StepRecord& now = record.steps.back();
  const bool speed_run = now.run == Run::speed;
  const bool goal_entered = played.row(i, RowColumn::goal_entered) != 0;
  ASSERT_TRUE(follower.belief.knowledge.learn(now.pose, now.sighting));
  if (record.steps.size() > 1) {
    const StepRecord& last = record.steps[record.steps.size() - 2];
    if (last.action.kind == Action::Kind::step) {
      const Heading heading = rotated(last.pose.heading, last.action.rotation);
      const Heading direction = last.action.movement < 0 ? opposite(heading) : heading;
      for (Cell cell = last.pose.cell; cell != now.pose.cell; cell = neighbour(cell, direction))
        follower.belief.visited.insert(cell);
    }
    follower.belief.visited.insert(now.pose.cell);
    EXPECT_EQ(played.row(i, RowColumn::blocked), last.blocked);
  }
  EXPECT_EQ(played.row(i, RowColumn::left), now.sighting.left);
  EXPECT_EQ(played.row(i, RowColumn::ahead), now.sighting.ahead);
  EXPECT_EQ(played.row(i, RowColumn::right), now.sighting.right);
  EXPECT_EQ(played.row(i, RowColumn::x), now.pose.cell.x);
  EXPECT_EQ(played.row(i, RowColumn::y), now.pose.cell.y);
  EXPECT_EQ(played.row(i, RowColumn::heading), static_cast<int>(now.pose.heading));
  EXPECT_EQ(played.row(i, RowColumn::speed_run), speed_run);
  EXPECT_EQ(played.row(i, RowColumn::steps_left), rules.budget - (now.step - 1));
  const Size size = follower.maze.size();
  for (int y = 0; y < played.batch.size().height; ++y)
    for (int x = 0; x < played.batch.size().width; ++x) {
      const Cell cell(x, y);
      const BeliefBits expected = size.contains(cell)
                                      ? follower.belief.bits(follower.maze, cell, now.pose, speed_run, goal_entered)
                                      : BeliefBits{0};
      ASSERT_EQ(played.bits(i, cell), expected) << x << ',' << y << " after " << record.steps.size() - 1 << " steps";
    }
  for (int choice = 0; choice < choice_count; ++choice) {
    const Action action = action_of(choice);
    const StepResult result = perform(follower.maze, rules, now.pose, action);
    const bool unseen = action.rotation == 0 && action.movement < 0;
    const bool useful = action.kind == Action::Kind::reset ? goal_entered && !speed_run
                                                           : (unseen || !result.blocked) && result.pose != now.pose;
    const bool valid = played.masks[i * choice_count + static_cast<unsigned>(choice)] != 0;
    EXPECT_TRUE(valid == useful || (unseen && valid)) << "choice " << choice;
  }
}

void expect_ended(const Played& played, std::size_t i, const Follower& follower, const Rules& rules) {
  const RunRecord record = replay(follower, rules);
  ASSERT_EQ(record.steps.size(), follower.actions.size());
  const std::map<ContestState, Outcome> outcomes = {
      {ContestState::finished, Outcome::finished},
      {ContestState::out_of_steps, Outcome::out_of_steps},
      {ContestState::never_reset, Outcome::never_reset},
      {ContestState::speed_run_unfinished, Outcome::speed_run_unfinished}};
  EXPECT_EQ(outcomes.at(static_cast<ContestState>(played.states[i])), record.outcome);
  EXPECT_EQ(follower.sum, -score(record, rules).value.value_or(rules.failure_score));
  EXPECT_EQ(played.row(i, RowColumn::x), record.end.cell.x);
  EXPECT_EQ(played.row(i, RowColumn::y), record.end.cell.y);
}

/// Plays a batch beside the simulator until `contests` have ended; which outcomes there were.
std::map<int, int> follow(Played& played, const std::vector<Maze>& mazes, const Rules& rules, Rng& rng, int contests) {
  std::map<int, int> states;
  std::vector<Follower> followers;
  for (std::size_t i = 0; i < played.n; ++i) {
    followers.emplace_back(mazes[static_cast<std::size_t>(played.numbers[i])]);
    expect_shown(played, i, followers[i], rules);
  }
  while (contests > 0 && !testing::Test::HasFatalFailure()) {
    const auto ended = played.ended;
    played.batch.draw_valid_choices(rng, played.choices);
    for (auto& choice : played.choices)
      if (rng.chance(1, 3)) choice = rng.below(choice_count);
    EXPECT_TRUE(played.batch.step(played.choices));
    for (std::size_t i = 0; i < played.n; ++i) {
      if (ended[i] != 0) {
        EXPECT_EQ(played.rewards[i], 0.0);
        followers[i] = Follower(mazes[static_cast<std::size_t>(played.numbers[i])]);
      } else {
        followers[i].actions.push_back(action_of(static_cast<int>(played.choices[i])));
        followers[i].sum += played.rewards[i];
      }
      EXPECT_EQ(followers[i].sum, played.returns[i]);
      if (played.ended[i] == 0) {
        expect_shown(played, i, followers[i], rules);
        continue;
      }
      expect_ended(played, i, followers[i], rules);
      ++states[played.states[i]];
      --contests;
    }
  }
  return states;
}

TEST(ContestBatch, ShowsAndPaysWhatTheSimulatorDoes) {
  Rng rng(1);
  std::map<int, int> states;
  for (int trial = 0; trial < (test::sanitized ? 20 : 60) && !HasFatalFailure(); ++trial) {
    std::vector<Maze> mazes;
    for (int i = 0, count = 1 + rng.below(5); i < count; ++i) mazes.push_back(random_maze(rng));
    Rules rules;
    rules.budget = 1 + rng.below(60);
    const MazeOrder order = rng.chance(1, 2) ? MazeOrder::drawn : MazeOrder::in_turn;
    Played played(ContestBatch(1 + rng.below(6), mazes, order, rules), trial % 2 == 0);
    for (const auto& [state, times] : follow(played, mazes, rules, rng, 12)) states[state] += times;
  }
  EXPECT_EQ(states.size(), 4U) << "not every outcome was played";
}

TEST(ContestBatch, NoSumOfRewardsIsRounded) {
  const Rules rules;
  const double reward = search_reward(rules);
  EXPECT_NEAR(reward, -1.0 / 30, 1e-12);
  double explored = 0.0;
  for (int search_run = 0; search_run < rules.budget; ++search_run, explored += reward) {
    double sum = explored;
    for (int speed = 1; search_run + speed <= rules.budget; ++speed, sum -= 1.0) {
      const double target = -score_of(search_run, speed, rules);
      ASSERT_EQ(sum + (target - sum), target) << search_run << " + " << speed;
      ASSERT_NEAR(target - sum, -1.0, 1e-9);
      ASSERT_EQ(sum + (-100.0 - sum), -100.0) << search_run << " + " << speed;
    }
  }
}

TEST(ContestBatch, RefusesAChoiceThatIsNoneAndDoesNothing) {
  const std::vector<Maze> mazes(1, empty_generator.make({{5, 5}, 1, 0}));
  Played played(ContestBatch(2, mazes, MazeOrder::drawn), false);
  const auto before = played.rows;
  for (const std::int64_t wrong : {std::int64_t{-1}, std::int64_t{choice_count}, INT64_MAX, INT64_MIN}) {
    played.choices = {17, wrong};
    EXPECT_FALSE(played.batch.step(played.choices));
  }
  EXPECT_EQ(played.rows, before);
}

TEST(ContestBatch, AContestDependsOnItsOwnSeedAlone) {
  const MazeFamily family{&depth_first_generator, {6, 6}, 100, Split::train, 0};
  Played one(ContestBatch(1, family, MazeOrder::drawn), false);
  Played many(ContestBatch(5, family, MazeOrder::drawn), false);
  one.batch.seed(0, 77);
  one.batch.start();
  for (int i = 0; i < 5; ++i) many.batch.seed(i, static_cast<std::uint64_t>(75 + i));
  many.batch.start();
  for (int contest = 0; contest < 20; ++contest) {
    EXPECT_EQ(one.numbers[0], many.numbers[2]);
    EXPECT_NE(many.numbers[1], many.numbers[2]);
    one.batch.start();
    many.batch.start();
  }
}

TEST(ContestBatch, PlaysMadeMazesAsThoseOfAList) {
  LABMOUSE_SKIP_SANITIZED();
  const MazeFamily family{&contest_generator, {12, 12}, 0, Split::test, 4};
  std::vector<Maze> mazes;
  for (std::uint64_t number = 0; number < family.count; ++number) mazes.push_back(maze_of(family, number));
  Rules rules;
  rules.budget = 40;
  Rng rng(5);
  Played played(ContestBatch(3, family, MazeOrder::in_turn, rules), true);
  EXPECT_EQ(played.numbers, (std::vector<std::int64_t>{0, 1, 2}));
  follow(played, mazes, rules, rng, 9);
}

TEST(ContestBatch, MakesNoMazeOnceItIsStopped) {
  const MazeFamily family{&depth_first_generator, {4, 4}, 0, Split::train, 8};
  Played played(ContestBatch(3, family, MazeOrder::in_turn), false);
  int asked = 0;
  const auto second_on = [&asked] { return ++asked > 1; };
  played.batch.start(second_on);
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(played.numbers, (std::vector<std::int64_t>{3, 1, 2}));
  EXPECT_EQ(played.ended, (std::vector<std::uint8_t>{0, 1, 1}));
  // They begin with the next step, in the mazes that they would have had.
  ASSERT_TRUE(played.batch.step(played.choices));
  EXPECT_EQ(played.numbers, (std::vector<std::int64_t>{3, 4, 5}));
  EXPECT_EQ(played.ended, (std::vector<std::uint8_t>{0, 0, 0}));
}

TEST(ContestBatch, PlaysMazesInTurn) {
  const MazeFamily family{&depth_first_generator, {4, 4}, 0, Split::train, 8};
  Played played(ContestBatch(3, family, MazeOrder::in_turn), false);
  for (const auto& numbers : {std::vector<std::int64_t>{0, 1, 2}, {3, 4, 5}, {6, 7, 0}, {1, 2, 3}}) {
    EXPECT_EQ(played.numbers, numbers);
    played.batch.start();
  }
  played.batch.seed(0, 9);
  played.batch.start(std::vector<std::uint8_t>{1, 0, 0});
  EXPECT_EQ(played.numbers[0], 0) << "a seed begins from the first";
}

TEST(ContestBatch, ShowsTheRectangleAroundTheGoals) {
  CellSet goals = CellSet::of({4, 0});
  goals.insert({2, 1});
  const std::vector<Maze> mazes(1, empty_generator.make({{6, 5}, 1, 0}).with_goals(goals));
  Played played(ContestBatch(1, mazes, MazeOrder::drawn), false);
  EXPECT_EQ(played.row(0, RowColumn::goal_west), 2);
  EXPECT_EQ(played.row(0, RowColumn::goal_south), 0);
  EXPECT_EQ(played.row(0, RowColumn::goal_east), 4);
  EXPECT_EQ(played.row(0, RowColumn::goal_north), 1);
}

TEST(ContestBatch, StartsAnewOnlyWhereItIsAsked) {
  const std::vector<Maze> mazes(1, empty_generator.make({{5, 5}, 1, 0}));
  Played played(ContestBatch(3, mazes, MazeOrder::drawn), false);
  played.choices.assign(3, 10 + 1);
  ASSERT_TRUE(played.batch.step(played.choices));
  played.batch.start(std::vector<std::uint8_t>{0, 1, 0});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(played.row(i, RowColumn::steps_left), i == 1 ? 1000 : 999);
}

TEST(ContestBatch, AResetThatLeavesItInAGoalHasNotEnteredIt) {
  const std::vector<Maze> mazes(1, empty_generator.make({{3, 3}, 1, 0}).with_goals(CellSet::of({0, 0})));
  Played played(ContestBatch(1, mazes, MazeOrder::drawn), false);
  const auto choose = [&](int choice) {
    played.choices = {choice};
    ASSERT_TRUE(played.batch.step(played.choices));
  };
  choose(reset_choice);
  EXPECT_EQ(played.row(0, RowColumn::goal_entered), 0);
  choose(0 + longest_choice);  // a turn, which ends in the goal
  EXPECT_EQ(played.row(0, RowColumn::goal_entered), 1);
  choose(reset_choice);
  choose(reset_choice);
  EXPECT_EQ(played.ended[0], 0);
  choose(0 + longest_choice);
  EXPECT_EQ(played.ended[0], 1);
}

TEST(ContestBatch, DrawsEveryValidChoice) {
  const std::vector<Maze> mazes(1, contest_generator.make({{12, 12}, 3, 0}));
  Played played(ContestBatch(2000, mazes, MazeOrder::drawn), false);
  Rng rng(9);
  played.batch.draw_valid_choices(rng, played.choices);
  for (int choice = 0; choice < choice_count; ++choice)
    EXPECT_EQ(std::count(played.choices.begin(), played.choices.end(), choice) > 0,
              played.masks[static_cast<std::size_t>(choice)] == 1)
        << choice;
}

TEST(ContestBatch, DrawsNoChoiceThatIsNotValid) {
  const std::vector<Maze> mazes(1, contest_generator.make({{12, 12}, 3, 0}));
  Played played(ContestBatch(500, mazes, MazeOrder::drawn), false);
  Rng rng(9);
  for (int step = 0; step < 20; ++step) {
    played.batch.draw_valid_choices(rng, played.choices);
    for (std::size_t i = 0; i < played.n; ++i)
      EXPECT_EQ(played.masks[i * choice_count + static_cast<std::size_t>(played.choices[i])], 1);
    ASSERT_TRUE(played.batch.step(played.choices));
  }
}

}  // namespace
}  // namespace labmouse
