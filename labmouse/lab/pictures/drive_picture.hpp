// Routes and contests in seconds as pictures: lines and curves, coloured by speed.
#pragma once

#include <string>

#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// One self-contained SVG picture with a legend: a route in its maze.
std::string draw_route(const Maze& maze, const DriveRoute& driven, const DriveModel& model, const std::string& title);

/// The same for a contest. One run is coloured by speed: the run that gives the score if it is a speed run, else the
/// last speed run. Search runs are thin lines; other speed runs are not drawn.
std::string draw_contest(const DriveRecordFile& file);

}  // namespace labmouse
