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
/// @param maze the briefing has its size, start and goals.
/// @param rules the briefing has its budget and stride.
/// @param seed for the random numbers of the strategy; the world has none.
Briefing brief(const Maze& maze, const Rules& rules, std::uint64_t seed);

/// Runs the contest to its end.
/// @param maze up to 64×64 cells.
/// @param rules budget in steps, stride in cells.
/// @param mouse new, or in the state in which a new one would be, and briefed as by brief().
/// @return every step, and the outcome; the reasons of the strategy if its briefing asks for them.
RunRecord run(const Maze& maze, const Rules& rules, Strategy& mouse);

}  // namespace labmouse
