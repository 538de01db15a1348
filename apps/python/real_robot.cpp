// Binds the map of a real robot.
#include <fmt/format.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "bindings.hpp"
#include "errors.hpp"
#include "labmouse/lab/live/live_drawing.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

/// The stream of a robot, and the map that it gives.
struct RealRobot {
  LiveReader reader;
  LiveMap map;
};

RealRobot robot_in(int width, int height, const NamedMaze* maze) {
  if (maze != nullptr) return {LiveReader(maze->maze.size()), LiveMap(maze->maze)};
  const Size size{width, height};
  if (!size.valid())
    throw UserError(fmt::format("no maze is {}x{}; both sides must be from 1 to {}", width, height, max_side));
  return {LiveReader(size), LiveMap(size)};
}

/// What a line says, and what is found in it.
nb::dict event_of(const LiveLine& line, LiveMap& map) {
  nb::dict event;
  event["line"] = line.number;
  event["restart"] = line.is_restart;
  if (line.seen) {
    event["cell"] = nb::make_tuple(static_cast<int>(line.seen->pose.cell.x), static_cast<int>(line.seen->pose.cell.y));
    event["heading"] = std::string(name_of(line.seen->pose.heading));
    nb::dict walls;
    for (const Heading side : all_headings)
      if (const auto closed = line.seen->closed[static_cast<std::size_t>(side)])
        walls[std::string(name_of(side)).c_str()] = *closed;
    event["walls"] = walls;
  }
  nb::dict fields;
  for (const LiveField& field : line.fields) fields[field.name.c_str()] = field.value;
  event["fields"] = fields;
  if (line.drawing) event["drawing"] = *write_partial_map(*line.drawing).content;
  nb::list findings;
  for (const LiveFinding& finding : map.add(line)) findings.append(words_of(finding));
  event["findings"] = findings;
  return event;
}

nb::list feed(RealRobot& robot, const nb::bytes& data) {
  nb::list events;
  for (const LiveLine& line : robot.reader.feed(std::string_view(data.c_str(), data.size())))
    events.append(event_of(line, robot.map));
  return events;
}

std::optional<std::tuple<int, int, std::string>> pose_of(const RealRobot& robot) {
  const auto& pose = robot.map.pose();
  if (!pose) return std::nullopt;
  return std::make_tuple(pose->cell.x, pose->cell.y, std::string(name_of(pose->heading)));
}

}  // namespace

void bind_real_robots(nb::module_& module) {
  nb::class_<RealRobot>(module, "RealRobot",
                        "The map of a real robot, from the bytes that it sends (docs/reference/protocols.md).\n\n"
                        "Its text is the drawing of `labmouse live`.")
      .def(
          "__init__",
          [](RealRobot* self, int width, int height, const NamedMaze* maze) {
            new (self) RealRobot(robot_in(width, height, maze));
          },
          "width"_a = 16, "height"_a = 16, "maze"_a = nb::none(),
          nb::sig("def __init__(self, width: int = 16, height: int = 16, maze: Maze | None = None) -> None"),
          "A robot in a maze of that size that nobody knows, or in a maze that is known: then width and height do not "
          "count, and false and missed walls are findings.")
      .def("feed", &feed, "data"_a, nb::sig("def feed(self, data: bytes) -> list[dict[str, typing.Any]]"),
           "Adds bytes, in any pieces. Returns a dict for each line that ends in them and is no noise: its number "
           "`line`; `restart`; `cell`, `heading` and `walls` (True: closed) if it has them; `fields`; `drawing` if it "
           "ends one; and `findings`, the lines that `labmouse live` prints.")
      .def_prop_ro("pose", &pose_of, "Where the robot is: x, y and its heading; None until a line says it.")
      .def_prop_ro(
          "fields", [](const RealRobot& robot) { return robot.map.fields(); }, "The newest value of each field.")
      .def_prop_ro(
          "text", [](const RealRobot& robot) { return *write_partial_map(robot.map.map()).content; },
          "The map as a drawing, which `labmouse show` and `labmouse inspect` read.")
      .def_prop_ro(
          "contradictions",
          [](const RealRobot& robot) {
            std::vector<std::string> all;
            for (const LiveFinding& finding : robot.map.contradictions()) all.push_back(words_of(finding));
            return all;
          },
          "The walls that were seen in both states, a line each.")
      .def_prop_ro(
          "lines", [](const RealRobot& robot) { return robot.reader.lines(); }, "How many lines have ended.")
      .def_prop_ro(
          "noise", [](const RealRobot& robot) { return robot.reader.noise(); }, "How many of them are noise.")
      .def("__str__",
           [](const RealRobot& robot) { return draw_live(robot.map, false) + live_summary(robot.map, robot.reader); });
}

}  // namespace labmouse::python
