// A robot with the tables that follow from its limits: what a contest in seconds is driven by.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "labmouse/mouse/robot/robot.hpp"
#include "labmouse/mouse/robot/tables.hpp"
#include "labmouse/mouse/robot/turn_shape.hpp"

namespace labmouse {

class RouteTables;

/// The tables of a robot, with its turns' shapes, or a sentence that says in mm and mm/s what does not fit and why.
struct DriveModel {
  DriveTables tables;
  /// By Turn and then by speed as in tables.turns: the shape of tables.turns[i] is shapes[i], in its first direction of
  /// driving (a turn back from a diagonal has a shape of its own). The time of the turn is that from the lead of the
  /// lane it begins in to whole() less the lead of the lane it ends in; what is left of the shape is part of the
  /// straights.
  std::vector<TurnShape> shapes;
  SearchDrive search;
  Robot robot;  ///< the one that it was made of
  std::string error;
  /// What its searches for routes share, where it is kept: share_route_tables() makes it.
  std::shared_ptr<const RouteTables> route_tables;
};

DriveModel make_drive_model(const Robot& robot);

}  // namespace labmouse
