// A robot with the tables that follow from its limits: the model for contests in seconds.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "labmouse/mouse/robot/robot.hpp"
#include "labmouse/mouse/robot/tables.hpp"
#include "labmouse/mouse/robot/turn_shape.hpp"

namespace labmouse {

class RouteTables;

/// The tables of a robot and the shapes of its turns, or a text that says what does not fit and why, in mm and mm/s.
struct DriveModel {
  DriveTables tables;
  /// By Turn and then by speed as in tables.turns: the shape of tables.turns[i] is shapes[i], as it is driven (a turn
  /// back from a diagonal has a shape of its own). The turn's time is that from the lead of its first lane to whole()
  /// less the lead of its last lane; the rest of the shape belongs to the straights.
  std::vector<TurnShape> shapes;
  /// The times of its search.
  SearchDrive search;
  Robot robot;  ///< the one that it was made of
  /// Empty for a model that can be used. Otherwise the reason why the robot is refused, and nothing else is set.
  std::string error;
  /// Tables that its route searches share, if share_route_tables() was called.
  std::shared_ptr<const RouteTables> route_tables;
};

/// Computes the tables of a robot, or finds out why it cannot be simulated.
/// @param robot its limits, or its published times.
/// @return the model; check its `error` before its use.
DriveModel make_drive_model(const Robot& robot);

}  // namespace labmouse
