// Runs one contest in the world of steps. docs/reference/worlds-and-rules.md explains the rules.
#pragma once

#include "labmouse/contest/contest.hpp"
#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// Information for a strategy before the contest: size, start, goals and moves, but no walls.
Briefing brief(const Maze& maze, const Rules& rules, std::uint64_t seed);

/// Runs the contest to its end. The strategy must be new, or in the state in which a new one would be. The record has
/// its reasons if its briefing asks for them.
RunRecord run(const Maze& maze, const Rules& rules, Strategy& mouse);

}  // namespace labmouse
