// The course of a time trial: laps of the outermost ring of a maze, clockwise from the start in a corner. The mouse
// knows the course, so the route is computed once, turn by turn.
#pragma once

#include <optional>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// Whether the start is in a corner of the maze, and its heading leads clockwise round the outermost ring. The maze
/// must have at least two rows and two columns.
bool starts_on_ring(const Maze& maze);
/// The walls between the cells of the outermost ring: the course leads through all of them.
WallSet ring_of(Size size);
/// The first closed wall on the course, clockwise from the start; nothing if the ring is open all round. The maze must
/// pass starts_on_ring().
std::optional<Wall> closed_on_ring(const Maze& maze);

/// The route of so many laps: from rest at the start, each lap through the gate (the exit of the start cell), and after
/// the last gate to the middle of the next cell, or of a later one where the robot can stop. Each corner is driven by
/// one of the robot's turns of 90 degrees. The laps between the first and the last are equal, and of all turns at the
/// four corners they have the fastest ones. The first lap has those with the least time from rest to the end of its
/// last turn; it can be the fastest lap, because the robot passes the first gate on a straight and later ones in or
/// after a turn. If the last lap ends with another turn, this is because the robot could not stop on the first side
/// after the fastest one. The route has fewer laps if its time would reach no_time. It has no segments and no_time if
/// the start is not on the ring, the ring is closed, or the robot has no turns for it.
DriveRoute lap_route(const Maze& maze, const DriveModel& model, int laps);

/// The time of the laps between the first and the last, in microseconds, which are the fastest that can be repeated;
/// no_time if none can be driven.
DriveTime flying_lap(const Maze& maze, const DriveModel& model);

}  // namespace labmouse
