// One contest: a mouse, a maze and the rules of the world of steps. docs/reference/worlds-and-rules.md has them in
// words.
#pragma once

#include "labmouse/contest/contest.hpp"
#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// What a mouse knows of a maze before the contest: the size, the start, the goals and its moves, but no wall.
Briefing brief(const Maze& maze, const Rules& rules, std::uint64_t seed);

/// Runs the contest to its end. The strategy must be new, or in the state in which a new one would be. The record has
/// its reasons if its briefing asks for them.
RunRecord run(const Maze& maze, const Rules& rules, Strategy& mouse);

}  // namespace labmouse
