// Any bytes as a robot: there is a robot with a model, or there are problems; and the model keeps what it promises.
#include "labmouse/lab/robots/robot_file.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(robot) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const RobotResult read = read_robot(text, "fuzz");
  require(read.robot.has_value() == read.problems.empty());
  require(read.problems.size() <= most_problems);
  if (!read.robot) return 0;
  const DriveTables& tables = read.model.tables;
  require(tables.shortest_turn() >= 1000);
  require(tables.turns.size() == read.model.shapes.size());
  for (const auto* straights : {&tables.along, &tables.diagonal})
    for (const DriveTime time : straights->between) require(time >= 0 && time <= no_time);
  for (const TurnShape& shape : read.model.shapes) require(shape.lead_in >= 0.0 && shape.lead_out >= 0.0);
  return 0;
}

}  // namespace labmouse::fuzz
