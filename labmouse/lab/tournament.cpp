#include "labmouse/lab/tournament.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>

#include "labmouse/chance/dice.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/parallel.hpp"
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

std::vector<ContestResult> list_contests(const Race& race) {
  std::vector<ContestResult> contests;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse)
    for (std::size_t maze = 0; maze < race.mazes.size(); ++maze)
      for (int run = 0; run < runs_of(race.mice[mouse], race.order); ++run) {
        ContestResult contest;
        contest.mouse = mouse;
        contest.maze = maze;
        contest.run = run;
        contest.seed = contest_seed(race.order.seed, race.mazes[maze].name, run);
        contests.push_back(contest);
      }
  return contests;
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

std::uint64_t contest_seed(std::uint64_t seed, std::string_view maze_name, int run) {
  // 53 bits: a JSON reader that keeps numbers as doubles gets them whole.
  return seed_for(seed, maze_name.substr(maze_name.rfind('/') + 1), static_cast<std::uint64_t>(run)) >> 11U;
}

Race hold_race(std::vector<Contestant> mice, std::vector<NamedMaze> mazes, const RaceOrder& order,
               const RaceHooks& hooks) {
  Race race;
  race.order = order;
  race.mice = std::move(mice);
  race.mazes = std::move(mazes);
  const auto by_name = [](const auto& a, const auto& b) { return a.name < b.name; };
  std::sort(race.mice.begin(), race.mice.end(), by_name);
  std::sort(race.mazes.begin(), race.mazes.end(), by_name);
  for (const NamedMaze& maze : race.mazes) {
    race.bounds.push_back(bound_of(maze.maze, order.rules));
    race.reachable.push_back(reachable_cells(maze.maze));
  }
  race.results = list_contests(race);

  std::mutex telling;
  const auto hold = [&](std::size_t i) {
    if (hooks.stop != nullptr && hooks.stop->load()) return;
    const RunRecord record = hold_contest(race, race.results[i]);
    if (!hooks.finished || !race.results[i].done) return;
    const std::lock_guard lock(telling);
    hooks.finished(race, race.results[i], record);
  };
  for_each_parallel(race.results.size(), order.jobs, hold);
  race.stopped = std::any_of(race.results.begin(), race.results.end(), [](const ContestResult& r) { return !r.done; });
  return race;
}

}  // namespace labmouse
