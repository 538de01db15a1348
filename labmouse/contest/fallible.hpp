// One contest in the fallible world: that of seconds, in which mice stray, misread walls and crash by dice whose
// chances were counted in the physical world. It is fast, and what a mind has to cope with is the same.
//
// How far astray a mouse is goes on from manoeuvre to manoeuvre, and how unlucky its draws are is the same all through
// a contest: a bad mouse fails again.
#pragma once

#include <cstdint>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/hazards.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// Raised where the same contest comes to another end.
inline constexpr int fallible_edition = 1;

/// Holds the contest, in a maze up to 32×32, with a robot that has limits and hardware, under the noise of the
/// conditions, their map and their handling. The strategy must be new and briefed as by brief(), with a sight of one
/// cell. The draws of a seed are those of the physical world.
PhysicalRecord drive_fallibly(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                              const PhysicalConditions& conditions, const Hazards& hazards, std::uint64_t seed,
                              Strategy& mouse);

}  // namespace labmouse
