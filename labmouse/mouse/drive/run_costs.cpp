#include "labmouse/mouse/drive/run_costs.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <new>

#include "labmouse/mouse/drive/edges.hpp"

namespace labmouse {
namespace {

constexpr std::size_t bits = 16;
constexpr std::size_t words_for(std::size_t states) { return (states + bits - 1) / bits; }

/// The quarters of each turn, to the right: straight on, left and right.
constexpr std::array<std::size_t, 3> quarters = {0, 3, 1};

}  // namespace

std::size_t RunCosts::bytes_for(Size size) {
  const auto area = static_cast<std::size_t>(size.area()), states = 4 * lasts * area;
  return (2 * states + words_for(states) + area) * sizeof(std::uint16_t) + 2 * states + 4 * area;
}

RunCosts::RunCosts(Size size, std::span<std::byte> memory) : size_(size), ahead_(edges_ahead(size)) {
  assert(memory.size() >= bytes_for(size));
  const auto area = static_cast<std::size_t>(size.area());
  auto* const numbers = new (memory.data()) std::uint16_t[2 * states() + words_for(states()) + area];
  waiting_ = numbers + 2 * states();
  least_ = waiting_ + words_for(states());
  auto* const small = new (least_ + area) std::uint8_t[2 * states() + 4 * area];
  from_start_ = {numbers, small};
  to_goal_ = {numbers + states(), small + states()};
  walls_ = small + 2 * states();
}

void RunCosts::set_walls(const WallPrices& walls, const RunTolls& tolls) {
  tolls_ = tolls;
  std::fill(walls_, walls_ + 4 * size_.area(), std::uint8_t{WallPrices::closed});
  const auto set = [&](std::size_t side, int price) {
    // A price above 0 counts as at least one step.
    const int steps = price == 0 ? 0 : std::max(price / price_step, 1);
    walls_[side] = walls_[behind(side) + ahead_[side % 4]] =
        static_cast<std::uint8_t>(price < tolls.closed ? steps : WallPrices::closed);
  };
  const auto width = static_cast<std::size_t>(size_.width), area = static_cast<std::size_t>(size_.area());
  for (std::size_t row = 0; row < area; row += width)
    for (std::size_t cell = row; cell < row + width; ++cell) {
      if (row + width < area) set(4 * cell + static_cast<std::size_t>(Heading::north), walls.north()[cell]);
      if (cell + 1 < row + width) set(4 * cell + static_cast<std::size_t>(Heading::east), walls.east()[cell]);
    }
  for (std::size_t steps = 0; steps < tolls_of_steps_.size(); ++steps)
    tolls_of_steps_[steps] = toll(static_cast<int>(steps));
}

/// Finds a lower bound of what a run costs from an edge into each cell on: the distance to the rectangle around the
/// goals, by the cheapest edges.
void RunCosts::find_least() {
  Cell south_west = {size_.width, size_.height}, north_east = {0, 0};
  goals_.for_each([&](Cell cell) {
    south_west = {std::min(south_west.x, cell.x), std::min(south_west.y, cell.y)};
    north_east = {std::max(north_east.x, cell.x), std::max(north_east.y, cell.y)};
  });
  const int edge = std::min({run_.straight, run_.turn, run_.opposite, run_.again});
  for (int index = 0; index < size_.area(); ++index) {
    const Cell cell = size_.cell_at(index);
    const int x = std::max({south_west.x - cell.x, cell.x - north_east.x, 0});
    const int y = std::max({south_west.y - cell.y, cell.y - north_east.y, 0});
    least_[index] = static_cast<std::uint16_t>(std::min((x + y) * edge, no_run));
  }
}

void RunCosts::aim(const RunPrices& run, Pose start, const CellSet& goals) {
  run_ = run;
  start_ = start;
  goals_ = goals;
  costs_[straight] = {run.straight, run.turn, run.turn};
  costs_[left] = {run.straight, run.again, run.opposite};
  costs_[right] = {run.straight, run.opposite, run.again};
}

void RunCosts::clear(Field& field, int limit) {
  limit_ = std::min(limit, no_run);
  std::fill(field.costs, field.costs + states(), static_cast<std::uint16_t>(no_run));
  std::fill(waiting_, waiting_ + words_for(states()), static_cast<std::uint16_t>(0));
  filled_ = {};
}

inline void RunCosts::reach(Field& field, std::size_t number, int cost, int steps) {
  if (cost >= field.costs[number]) return;
  field.costs[number] = static_cast<std::uint16_t>(cost);
  field.prices[number] = static_cast<std::uint8_t>(std::min(steps, 0xff));
  const std::size_t word = number / bits;
  waiting_[word] = static_cast<std::uint16_t>(waiting_[word] | 1U << number % bits);
  filled_[word / 64] |= std::uint64_t{1} << word % 64;
}

inline void RunCosts::reach_from_start(std::size_t edge, std::size_t last, int cost, int steps) {
  if (cost + least_[edge / 4] < limit_) reach(from_start_, lasts * edge + last, cost, steps);
}

inline void RunCosts::reach_to_goal(std::size_t edge, std::size_t last, int cost, int steps) {
  const std::size_t number = lasts * edge + last;
  if (cost + from_start_.costs[number] < limit_) reach(to_goal_, number, cost, steps);
}

inline void RunCosts::go_on(std::size_t number) {
  const std::size_t edge = number / lasts, last = number % lasts;
  const int cost = from_start_.costs[number], price = from_start_.prices[number];
  for (const std::size_t next : {straight, left, right}) {
    const std::size_t side = turned_edge(edge, quarters[next]);
    const std::size_t steps = walls_[side];
    if (steps == WallPrices::closed) continue;
    reach_from_start(side + ahead_[side % 4], next, cost + costs_[last][next] + tolls_of_steps_[steps],
                     price + static_cast<int>(steps));
  }
}

inline void RunCosts::go_back(std::size_t number) {
  const std::size_t edge = number / lasts, next = number % lasts;
  const std::size_t steps = walls_[behind(edge)];
  if (steps == WallPrices::closed) return;
  const int cost = to_goal_.costs[number] + tolls_of_steps_[steps];
  const int price = to_goal_.prices[number] + static_cast<int>(steps);
  const std::size_t before = turned_edge(edge - ahead_[edge % 4], 4 - quarters[next]);
  for (const std::size_t last : {straight, left, right}) reach_to_goal(before, last, cost + costs_[last][next], price);
}

/// Expands all queued states, and those that this queues, in rounds by their numbers.
template <class Expand>
void RunCosts::search(Expand expand) {
  for (bool any = true; any;) {
    any = false;
    for (std::size_t group = 0; group < filled_.size(); ++group)
      for (std::uint64_t rest = ~std::uint64_t{0}; (filled_[group] & rest) != 0;) {
        const auto place = static_cast<unsigned>(std::countr_zero(filled_[group] & rest));
        const std::size_t word = 64 * group + place;
        while (waiting_[word] != 0) {
          const auto bit = static_cast<unsigned>(std::countr_zero(waiting_[word]));
          waiting_[word] = static_cast<std::uint16_t>(waiting_[word] & (waiting_[word] - 1U));
          expand(word * bits + bit);
        }
        filled_[group] &= ~(std::uint64_t{1} << place);
        // What this queues in earlier words waits for the next round.
        rest = ~std::uint64_t{1} << place;
        any = true;
      }
  }
}

void RunCosts::begin() {
  // A run begins straight on.
  const std::size_t side = edges_of(start_.cell) + static_cast<std::size_t>(start_.heading);
  const int steps = walls_[side];
  if (steps != WallPrices::closed)
    reach_from_start(side + ahead_[side % 4], straight, run_.straight + toll(steps), steps);
}

int RunCosts::known(const WallPrices& walls) {
  if (goals_.contains(start_.cell)) return 0;
  set_walls(walls, {0, 0, 1});
  find_least();
  clear(from_start_, no_run);
  begin();
  search([&](std::size_t number) {
    // What costs as much as the best run so far is no part of a better one.
    if (from_start_.costs[number] >= limit_) return;
    if (goals_.contains(size_.cell_at(static_cast<int>(number / lasts / 4)))) {
      limit_ = from_start_.costs[number];
    } else {
      go_on(number);
    }
  });
  return limit_;
}

void RunCosts::plan(const WallPrices& walls, const RunTolls& tolls, int limit) {
  set_walls(walls, tolls);
  find_least();
  clear(from_start_, limit);
  begin();
  search([&](std::size_t number) { go_on(number); });
  clear(to_goal_, limit);
  goals_.for_each([&](Cell cell) {
    for (std::size_t heading = 0; heading < 4; ++heading)
      for (const std::size_t last : {straight, left, right}) reach_to_goal(edges_of(cell) + heading, last, 0, 0);
  });
  search([&](std::size_t number) { go_back(number); });
}

std::optional<OptimisticRun> RunCosts::through(Cell cell) const {
  int least = limit_, steps = 0;
  const std::size_t first = lasts * edges_of(cell);
  for (std::size_t number = first; number < first + 4 * lasts; ++number) {
    const int cost = from_start_.costs[number] + to_goal_.costs[number];
    if (cost >= least) continue;
    least = cost;
    steps = from_start_.prices[number] + to_goal_.prices[number];
  }
  if (least == limit_) return std::nullopt;
  const int price = steps * price_step;
  return OptimisticRun{least - price * tolls_.per_nat / 32, price};
}

}  // namespace labmouse
