#include "labmouse/mouse/drive/run_costs.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <new>

namespace labmouse {
namespace {

constexpr std::size_t bits = 16;
constexpr std::size_t words_for(std::size_t states) { return (states + bits - 1) / bits; }

}  // namespace

std::size_t RunCosts::bytes_for(Size size) {
  const auto area = static_cast<std::size_t>(size.area()), states = 4 * lasts * area;
  return (2 * states + words_for(states)) * sizeof(std::uint16_t) + 2 * states + 2 * area;
}

RunCosts::RunCosts(Size size, std::span<std::byte> memory) : size_(size) {
  assert(memory.size() >= bytes_for(size));
  auto* const numbers = new (memory.data()) std::uint16_t[2 * states() + words_for(states())];
  waiting_ = numbers + 2 * states();
  const std::size_t walls = 2 * static_cast<std::size_t>(size.area());
  auto* const small = new (waiting_ + words_for(states())) std::uint8_t[2 * states() + walls];
  from_start_ = {numbers, small};
  to_goal_ = {numbers + states(), small + states()};
  walls_ = small + 2 * states();
}

std::size_t RunCosts::number_of(const State& state) const {
  const auto edge = static_cast<std::size_t>(4 * size_.index(state.cell) + static_cast<int>(state.heading));
  return edge * lasts + state.last;
}

RunCosts::State RunCosts::state_at(std::size_t number) const {
  const std::size_t edge = number / lasts;
  return {size_.cell_at(static_cast<int>(edge / 4)), all_headings[edge % 4], static_cast<Last>(number % lasts)};
}

void RunCosts::set_walls(const WallPrices& walls, const RunTolls& tolls) {
  tolls_ = tolls;
  for (int index = 0; index < size_.area(); ++index)
    for (const Heading heading : {Heading::north, Heading::east}) {
      const Wall wall = wall_at(size_.cell_at(index), heading);
      const int price = on_border(wall, size_) ? WallPrices::closed : walls.of(wall);
      // A price above 0 counts as at least one step.
      const int steps = price == 0 ? 0 : std::max(price / price_step, 1);
      walls_[2 * index + (heading == Heading::east ? 1 : 0)] =
          static_cast<std::uint8_t>(price < tolls.closed ? steps : WallPrices::closed);
    }
}

int RunCosts::steps_of(Cell cell, Heading heading) const {
  const Wall wall = wall_at(cell, heading);
  if (!size_.contains(wall.cell)) return WallPrices::closed;
  return walls_[2 * size_.index(wall.cell) + (wall.side == Heading::east ? 1 : 0)];
}

int RunCosts::cost_of(Last last, Last next) const {
  if (next == straight) return run_.straight;
  if (last == straight) return run_.turn;
  return last == next ? run_.again : run_.opposite;
}

/// A lower bound of what a run costs from an edge into that cell on.
int RunCosts::least_from(Cell cell) const {
  const int x = std::max({south_west_.x - cell.x, cell.x - north_east_.x, 0});
  const int y = std::max({south_west_.y - cell.y, cell.y - north_east_.y, 0});
  return (x + y) * std::min({run_.straight, run_.turn, run_.opposite, run_.again});
}

void RunCosts::aim(const RunPrices& run, Pose start, const CellSet& goals) {
  run_ = run;
  start_ = start;
  goals_ = goals;
  south_west_ = {size_.width, size_.height};
  north_east_ = {0, 0};
  goals.for_each([&](Cell cell) {
    south_west_ = {std::min(south_west_.x, cell.x), std::min(south_west_.y, cell.y)};
    north_east_ = {std::max(north_east_.x, cell.x), std::max(north_east_.y, cell.y)};
  });
}

void RunCosts::clear(Field& field, int limit) {
  limit_ = std::min(limit, no_run);
  std::fill(field.costs, field.costs + states(), static_cast<std::uint16_t>(no_run));
  std::fill(waiting_, waiting_ + words_for(states()), static_cast<std::uint16_t>(0));
}

void RunCosts::reach(Field& field, std::size_t number, int cost, int steps) {
  if (cost >= field.costs[number]) return;
  field.costs[number] = static_cast<std::uint16_t>(cost);
  field.prices[number] = static_cast<std::uint8_t>(std::min(steps, 0xff));
  waiting_[number / bits] = static_cast<std::uint16_t>(waiting_[number / bits] | 1U << number % bits);
}

void RunCosts::reach_from_start(const State& state, int cost, int steps) {
  if (cost + least_from(state.cell) < limit_) reach(from_start_, number_of(state), cost, steps);
}

void RunCosts::reach_to_goal(const State& state, int cost, int steps) {
  const std::size_t number = number_of(state);
  if (cost + from_start_.costs[number] < limit_) reach(to_goal_, number, cost, steps);
}

void RunCosts::go_on(std::size_t number) {
  const State at = state_at(number);
  for (const Last next : {straight, left, right}) {
    const Heading heading = next == straight ? at.heading : next == left ? left_of(at.heading) : right_of(at.heading);
    const int steps = steps_of(at.cell, heading);
    if (steps == WallPrices::closed) continue;
    reach_from_start({neighbour(at.cell, heading), heading, next},
                     from_start_.costs[number] + cost_of(at.last, next) + toll(steps),
                     from_start_.prices[number] + steps);
  }
}

void RunCosts::go_back(std::size_t number) {
  const State at = state_at(number);
  const Cell before = neighbour(at.cell, at.heading, -1);
  const int steps = size_.contains(before) ? steps_of(before, at.heading) : WallPrices::closed;
  if (steps == WallPrices::closed) return;
  const Heading heading = at.last == straight ? at.heading
                          : at.last == left   ? right_of(at.heading)
                                              : left_of(at.heading);
  for (const Last last : {straight, left, right})
    reach_to_goal({before, heading, last}, to_goal_.costs[number] + cost_of(last, at.last) + toll(steps),
                  to_goal_.prices[number] + steps);
}

/// Expands all queued states, and those that this queues.
template <class Expand>
void RunCosts::search(Expand expand) {
  for (bool any = true; any;) {
    any = false;
    for (std::size_t word = 0; word < words_for(states()); ++word)
      while (waiting_[word] != 0) {
        const auto bit = static_cast<unsigned>(std::countr_zero(waiting_[word]));
        waiting_[word] = static_cast<std::uint16_t>(waiting_[word] & (waiting_[word] - 1U));
        expand(word * bits + bit);
        any = true;
      }
  }
}

void RunCosts::begin() {
  // A run begins straight on.
  const int steps = steps_of(start_.cell, start_.heading);
  if (steps != WallPrices::closed)
    reach_from_start({neighbour(start_.cell, start_.heading), start_.heading, straight}, run_.straight + toll(steps),
                     steps);
}

int RunCosts::known(const WallPrices& walls) {
  if (goals_.contains(start_.cell)) return 0;
  set_walls(walls, {0, 0, 1});
  clear(from_start_, no_run);
  begin();
  search([&](std::size_t number) {
    // What costs as much as the best run so far is no part of a better one.
    if (from_start_.costs[number] >= limit_) return;
    if (goals_.contains(state_at(number).cell)) {
      limit_ = from_start_.costs[number];
    } else {
      go_on(number);
    }
  });
  return limit_;
}

void RunCosts::plan(const WallPrices& walls, const RunTolls& tolls, int limit) {
  set_walls(walls, tolls);
  clear(from_start_, limit);
  begin();
  search([&](std::size_t number) { go_on(number); });
  clear(to_goal_, limit);
  goals_.for_each([&](Cell cell) {
    for (const Heading heading : all_headings)
      for (const Last last : {straight, left, right}) reach_to_goal({cell, heading, last}, 0, 0);
  });
  search([&](std::size_t number) { go_back(number); });
}

std::optional<OptimisticRun> RunCosts::through(Cell cell) const {
  int least = limit_, steps = 0;
  const std::size_t first = number_of({cell, all_headings[0], straight});
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
