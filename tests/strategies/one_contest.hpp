// One contest of one mouse, for tests of its manners.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse::test {

using Values = std::vector<std::pair<std::string_view, std::string_view>>;

/// The record of a mouse with some parameters set, under a seed for its random choices.
inline RunRecord contest(const BuiltinMouse& mouse, const Maze& maze, const Values& values = {}, std::uint64_t seed = 1,
                         const Rules& rules = {}) {
  Settings settings(mouse.parameters);
  for (const auto& [name, value] : values) settings.set(name, value);
  return run(maze, rules, *mouse.make(brief(maze, rules, seed), settings));
}

/// Mazes with loops and dead ends.
inline std::vector<Maze> loopy_mazes() {
  std::vector<Maze> mazes;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U})
    for (const Generator* generator : {&prim_generator, &depth_first_generator, &kruskal_generator})
      mazes.push_back(generator->make({{12, 9}, seed, 150}));
  return mazes;
}

/// Calls check(step, knowledge) at each moving step of the search run, with all that was known when it was decided.
template <class Check>
void follow_search_run(const Maze& maze, const RunRecord& record, Check check) {
  Knowledge knowledge(maze.size());
  for (const StepRecord& step : record.steps) {
    if (step.run == Run::speed || step.action.kind != Action::Kind::step) return;
    if (!knowledge.learn(step.pose, step.sighting)) return;
    check(step, knowledge);
  }
}

}  // namespace labmouse::test
