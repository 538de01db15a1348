#include "labmouse/lab/races/tournament.hpp"

#include <chrono>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/races/contest_list.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

/// A mouse with a stopwatch, which minds themselves may not have.
class Timed final : public Strategy {
 public:
  explicit Timed(Strategy& mouse) : mouse_(mouse) {}

  Action decide(const Sighting& seen) override {
    const auto begin = std::chrono::steady_clock::now();
    const Action action = mouse_.decide(seen);
    spent_ += std::chrono::steady_clock::now() - begin;
    return action;
  }
  const Knowledge& knowledge() const override { return mouse_.knowledge(); }
  std::span<const Counter> counters() const override { return mouse_.counters(); }
  std::string_view last_words() override { return mouse_.last_words(); }
  double microseconds() const { return std::chrono::duration<double, std::micro>(spent_).count(); }

 private:
  Strategy& mouse_;
  std::chrono::steady_clock::duration spent_{};
};

int runs_of(const Contestant& mouse, const RaceOrder& order) {
  if (mouse.runs > 0) return mouse.runs;
  return mouse.uses_chance ? order.runs : 1;
}

RunRecord hold_contest(const Race& race, ContestResult& contest) {
  const Maze& maze = race.mazes[contest.maze].maze;
  const auto mouse = race.mice[contest.mouse].make(maze, race.order.rules, contest.seed);
  Timed timed(*mouse);
  RunRecord record = run(maze, race.order.rules, timed);
  contest.score = score(record, race.order.rules);
  contest.coverage = coverage_of(record, maze.size(), race.reachable[contest.maze]);
  contest.missteps = missteps_of(record, race.order.rules);
  if (record.outcome == Outcome::forfeit) contest.reason = record.steps.back().action.reason;
  contest.started = mouse->started();
  contest.decisions = static_cast<int>(record.steps.size());
  contest.counts = record.counts;
  contest.last_words = record.last_words;
  contest.microseconds = timed.microseconds();
  contest.done = contest.reason != ForfeitReason::interrupted;
  return record;
}

}  // namespace

std::size_t contests_of(const std::vector<Contestant>& mice, std::size_t mazes, const RaceOrder& order) {
  std::size_t all = 0;
  for (const Contestant& mouse : mice) all += mazes * static_cast<std::size_t>(runs_of(mouse, order));
  return all;
}

Race hold_race(std::vector<Contestant> mice, std::vector<NamedMaze> mazes, const RaceOrder& order,
               const RaceHooks& hooks) {
  auto race = race_of<Race>(std::move(mice), std::move(mazes), order);
  for (const NamedMaze& maze : race.mazes) {
    race.bounds.push_back(bound_of(maze.maze, order.rules));
    race.reachable.push_back(reachable_cells(maze.maze));
  }
  list_contests(race, [&](const Contestant& mouse) { return runs_of(mouse, order); });
  hold_contests(race, hooks, [&](ContestResult& contest) { return hold_contest(race, contest); });
  return race;
}

}  // namespace labmouse
