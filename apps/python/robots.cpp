// Binds robots for labmouse.fit: parameters, robot files, turn curves, and drives on an open floor without noise.
#include <fmt/format.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>

#include "bindings.hpp"
#include "errors.hpp"
#include "labmouse/lab/drives/open_floor.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/lab/robots/robot_keys.hpp"
#include "labmouse/lab/robots/robot_text.hpp"
#include "labmouse/mouse/robot/turn_room.hpp"
#include "labmouse/mouse/robot/turn_shape.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

/// One value per tick (1 ms).
using Ticks = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

Robot robot_or_error(const std::string& name) {
  FoundRobot found = find_robot(name);
  if (!found.errors.empty()) throw UserError(fmt::format("{}", fmt::join(found.errors, "\n")));
  return std::move(found.robot);
}

/// The robot's name, and JSON of its parameters by the keys of robot files.
std::pair<std::string, std::string> robot_numbers(const std::string& name) {
  const Robot robot = robot_or_error(name);
  Json parameters = robot_json(robot, RobotParts::with_body)["parameters"];
  if (!robot.fixed) {
    parameters["curve.speeds"] = robot.speeds;
    parameters["stop"] = robot.stop == Stop::goal ? "goal" : "beyond";
  }
  return {robot.name, parameters.dump()};
}

/// The lowest and the highest allowed value of each key of robot files.
std::map<std::string, std::pair<double, double>> robot_ranges() {
  std::map<std::string, std::pair<double, double>> ranges;
  for (const RobotKey& key : robot_keys()) ranges[std::string(key.name)] = {key.low, key.high};
  return ranges;
}

/// The text of a robot file, and the first problem of that robot or an empty text. `parameters`: JSON; `remarks`:
/// the comment behind each number, by key; `otherwise`: the comment behind all others.
std::pair<std::string, std::string> robot_file(const std::string& parameters,
                                               const std::map<std::string, std::string>& remarks,
                                               const std::string& otherwise) {
  const std::string text = robot_text(ReadJson::parse(parameters), [&](std::string_view key) {
    const auto remark = remarks.find(std::string(key));
    return remark == remarks.end() ? otherwise : remark->second;
  });
  const RobotResult read = read_robot(text, "it");
  return {text, read.problems.empty() ? "" : read.problems.front().reason};
}

TurnShape shape_of(const std::string& name, double speed, const std::array<double, 4>& limits, double cell) {
  const auto* const turn =
      std::find_if(all_turns.begin(), all_turns.end(), [&](Turn one) { return name_of(one) == name; });
  if (turn == all_turns.end()) throw UserError(fmt::format("error: unknown turn '{}'", name));
  return shape_at(*turn, speed, {limits[0], limits[1], limits[2], limits[3]}, cell);
}

/// Width of the turn, length of its curve, and length with the straights before and after, in mm.
std::array<double, 3> turn_curve(const std::string& name, double speed, const std::array<double, 4>& limits,
                                 double cell) {
  const TurnShape shape = shape_of(name, speed, limits, cell);
  return {width_of(shape), shape.length, shape.whole()};
}

double turn_clearance(const std::string& name, double speed, const std::array<double, 4>& limits, double cell) {
  const TurnShape shape = shape_of(name, speed, limits, cell);
  return shape.lead_in < 0.0 || shape.lead_out < 0.0 ? 0.0 : clearance_of(shape, cell);
}

using Course = std::pair<std::vector<double>, std::vector<double>>;

/// Drives a robot and returns its distance (mm) and heading (rad, to the left) by tick. `stronger`: share by which its
/// right motor is stronger; `tick(floor, i)` simulates tick i. Throws UserError for a robot without hardware.
template <class Tick>
Course driven(const std::string& name, double stronger, std::size_t ticks, Tick tick) {
  const Robot robot = robot_or_error(name);
  if (!robot.hardware)
    throw UserError(
        fmt::format("error: {} does not say what it is built of, so it cannot be driven; take one that does, "
                    "such as classic or kerise",
                    name));
  OpenFloor floor(*robot.hardware, robot.cell, stronger);
  for (std::size_t i = 0; i + 1 < ticks; ++i) tick(floor, i);
  return {floor.ways(), floor.angles()};
}

Course drive_duties(const std::string& robot, double stronger, const Ticks& left, const Ticks& right) {
  return driven(robot, stronger, std::min(left.size(), right.size()), [&](OpenFloor& floor, std::size_t i) {
    floor.push({static_cast<float>(left(i)), static_cast<float>(right(i))});
  });
}

Course drive_speeds(const std::string& robot, const Ticks& speed, const Ticks& speeding, const Ticks& turning,
                    const Ticks& twisting) {
  const std::size_t ticks = std::min({speed.size(), speeding.size(), turning.size(), twisting.size()});
  return driven(robot, 0.0, ticks, [&](OpenFloor& floor, std::size_t i) {
    floor.follow({speed(i), speeding(i), turning(i), twisting(i)});
  });
}

}  // namespace

void bind_robots(nb::module_& module) {
  module.def("robot_numbers", &robot_numbers, "name"_a,
             "A robot's name, and JSON of its parameters. Raises Error if there is no such robot.");
  module.def("robot_ranges", &robot_ranges, "The lowest and the highest value of each key of robot files.");
  module.def("robot_file", &robot_file, "parameters"_a, "remarks"_a, "otherwise"_a,
             "The text of a robot file, and the first problem of that robot or ''.");
  module.def("turn_curve", &turn_curve, "turn"_a, "speed"_a, "limits"_a, "cell"_a,
             "Width of a turn, length of its curve, and length with its straights, in mm; `speed` is in mm/s.");
  module.def("turn_clearance", &turn_clearance, "turn"_a, "speed"_a, "limits"_a, "cell"_a,
             "Distance in mm from the path to the nearest wall or post; 0 where the curve does not fit.");
  module.def(
      "drive_duties", &drive_duties, "robot"_a, "stronger"_a, "left"_a, "right"_a,
      "Distance (mm) and heading (rad, to the left) of a robot by tick (1 ms) for given PWM duties of its motors, "
      "on an open floor and without noise. `stronger`: share by which the right motor is stronger.");
  module.def(
      "drive_speeds", &drive_speeds, "robot"_a, "speed"_a, "speeding"_a, "turning"_a, "twisting"_a,
      "The same for a robot whose controller follows speed and its derivative (mm/s, mm/s²) and yaw rate and its "
      "derivative (rad/s, rad/s²).");
}

}  // namespace labmouse::python
