#include "labmouse/contest/simulator.hpp"

#include <algorithm>
#include <utility>

namespace labmouse {
namespace {

std::vector<Count> counts_of(const Strategy& mouse) {
  std::vector<Count> counts;
  for (const Counter& counter : mouse.counters()) counts.push_back({std::string(counter.name), counter.value});
  std::sort(counts.begin(), counts.end(), [](const Count& a, const Count& b) { return a.name < b.name; });
  return counts;
}

}  // namespace

Briefing brief(const Maze& maze, const Rules& rules, std::uint64_t seed) {
  return {maze.size(), {maze.start(), maze.start_heading()}, maze.goals(), strides(rules.stride), rules.budget, seed};
}

RunRecord run(const Maze& maze, const Rules& rules, Strategy& mouse) {
  Contest contest(maze, rules);
  std::vector<StepReasons> kept;
  while (!contest.ended()) {
    contest.act(mouse.decide(contest.sighting()));
    if (const Reasons* reasons = mouse.reasons()) kept.push_back({contest.record().steps.back().step, *reasons});
  }
  RunRecord record = contest.take_record();
  record.counts = counts_of(mouse);
  record.last_words = mouse.last_words();
  record.reasons = std::move(kept);
  return record;
}

}  // namespace labmouse
