// Binds the best possible score of a maze and the fastest route.
#include <fmt/format.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "errors.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/routes/route_report.hpp"
#include "labmouse/lab/system/file_names.hpp"
#include "orders.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

std::optional<double> bound_in(const NamedMaze& maze, const GivenWorld& world) {
  Entry chosen = world_of(world.first, WorldSettings(world.second.begin(), world.second.end()));
  if (const std::string reason = chosen.world->refuse(maze.maze); !reason.empty())
    throw UserError(fmt::format("{}: error: {}", maze.name, reason));
  suit_defaults(chosen, {&maze, 1});
  const nb::gil_scoped_release others;
  return chosen.world->facts(maze.maze).bound;
}

/// The route as JSON, as a table and as a picture.
std::tuple<std::string, std::string, std::string> route_in(const NamedMaze& maze, const std::string& robot_name) {
  const FoundRobot robot = find_robot(robot_name);
  if (!robot.errors.empty()) throw UserError(fmt::format("{}", fmt::join(robot.errors, "\n")));
  const nb::gil_scoped_release others;
  const DriveModel& model = robot.model;
  const RouteReport report = route_report(maze.maze, model);
  if (!report.error.empty()) throw UserError(fmt::format("{}: error: {}", maze.name, report.error));
  const std::string title =
      fmt::format("{}: {}, {:.3f} s", stem_of(maze.name), model.robot.name, report.route.time / 1e6);
  return {json_of({report}, {maze}, model), table_of(report, maze, model),
          draw_route(maze.maze, report.route, model, title)};
}

}  // namespace

void bind_bounds(nb::module_& module) {
  module.def("bound", &bound_in, "maze"_a, "world"_a);
  module.def("route", &route_in, "maze"_a, "robot"_a);
}

}  // namespace labmouse::python
