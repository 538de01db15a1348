// Races of programs for mms to test with.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/mms/mms_world.hpp"
#include "tests/lab/races/race_fixture.hpp"

namespace labmouse::test {

/// A mouse that does what the words say; see tests/external/mms/mms_program.cpp.
inline Contestant mms_mouse(const std::string& name, std::vector<std::string> words) {
  Contestant mouse;
  mouse.name = "mms:" + name;
  mouse.runs = 1;
  words.insert(words.begin(), LABMOUSE_MMS_PROGRAM);
  Launch& program = mouse.kind.emplace<MmsProgram>().launch;
  program.words = std::move(words);
  program.limits.silence = std::chrono::seconds(20);  // on a busy machine
  return mouse;
}

/// The order of a race in the world of mms.
inline RaceOrder in_mms(const MmsOptions& options = {}) {
  RaceOrder order;
  order.world = mms_world(options);
  return order;
}

/// 3×1 cells: two moves from the start to the goal in the middle, the first one a turn.
inline NamedMaze plank() { return {"plank", drawn("o---o---o---o\n|           |\no---o---o---o")}; }

/// 1×5 cells, of which the centre cannot be reached.
inline NamedMaze shaft() {
  return {"shaft", drawn(R"(
    o---o
    |   |
    o   o
    |   |
    o---o
    |   |
    o   o
    |   |
    o---o
    |   |
    o---o
  )")};
}

/// A run that was never held: the best run and the totals make its score.
inline MmsRun imagined_run(float best_effective, float best_turns, float total_effective, float total_turns) {
  MmsRun run;
  run.end = "exit code 0";
  run.statistics.finished = true;
  run.statistics.best_run_distance = 2 * best_effective;
  run.statistics.best_run_effective_distance = best_effective;
  run.statistics.best_run_turns = best_turns;
  run.statistics.total_effective_distance = total_effective;
  run.statistics.total_turns = total_turns;
  run.statistics.score = best_effective + best_turns + 0.1F * (total_effective + total_turns);
  run.lines = 20;
  run.clock = 12.5;
  run.seconds = 0.25;
  return run;
}

/// A race that was never held, without results.
inline Race imagined_race(const std::vector<std::string>& mice, std::vector<NamedMaze> mazes) {
  Race race;
  race.order = in_mms();
  for (const std::string& mouse : mice) race.mice.push_back(mms_mouse(mouse, {}));
  race.mazes = std::move(mazes);
  for (const NamedMaze& maze : race.mazes) race.facts.push_back(race.world().facts(maze.maze));
  return race;
}

/// Adds a result to it: that of a run that was never held.
inline void imagine(Race& race, std::size_t mouse, std::size_t maze, const MmsRun& run) {
  ContestResult& result = race.results.emplace_back();
  result.mouse = mouse;
  result.maze = maze;
  sum_up(run, {}, race.facts[maze], result);
}

}  // namespace labmouse::test
