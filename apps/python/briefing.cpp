#include "briefing.hpp"

#include <fmt/format.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <new>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace nb = nanobind;

namespace labmouse::python {
namespace {

using Place = std::pair<int, int>;
/// The state for pickle: width, height, start, heading, goals; stride, budget, sight, seed; whether the world is in
/// seconds, and the time limit in microseconds.
using BriefingFields = std::tuple<std::tuple<int, int, Place, int, std::vector<Place>>,
                                  std::tuple<int, int, int, std::uint64_t>, std::tuple<bool, std::int64_t>>;

std::vector<Place> goals_of(const Briefing& briefing) {
  std::vector<Place> goals;
  briefing.goals.for_each([&](Cell cell) { goals.emplace_back(cell.x, cell.y); });
  return goals;
}

BriefingFields fields_of(const PythonBriefing& told) {
  const Briefing& briefing = told.briefing;
  const Pose& start = briefing.start;
  return {{briefing.size.width, briefing.size.height, Place(start.cell.x, start.cell.y),
           static_cast<int>(start.heading), goals_of(briefing)},
          {briefing.motion.longest, briefing.budget, briefing.sight, briefing.seed},
          {briefing.in_seconds(), briefing.drive.time_limit}};
}

/// Makes a briefing from its pickled state. Its robot is a placeholder: mice in Python see only whether there is one.
PythonBriefing briefing_of(const BriefingFields& fields) {
  static const DriveModel some_robot;
  const auto& [place, limits, seconds] = fields;
  const auto& [width, height, start, heading, goals] = place;
  PythonBriefing told;
  Briefing& briefing = told.briefing;
  briefing.size = {width, height};
  briefing.start = {{start.first, start.second}, turned(Heading::north, heading)};
  for (const auto& [x, y] : goals) briefing.goals.insert({x, y});
  briefing.motion = strides(std::get<0>(limits));
  std::tie(std::ignore, briefing.budget, briefing.sight, briefing.seed) = limits;
  if (std::get<0>(seconds)) briefing.drive.model = &some_robot;
  briefing.drive.time_limit = std::get<1>(seconds);
  return told;
}

}  // namespace

void bind_briefings(nb::module_& module) {
  nb::class_<PythonBriefing>(module, "Briefing", "What a mouse knows before its first step.")
      .def_prop_ro(
          "width", [](const PythonBriefing& told) { return told.briefing.size.width; }, "Columns of cells.")
      .def_prop_ro(
          "height", [](const PythonBriefing& told) { return told.briefing.size.height; }, "Rows of cells.")
      .def_prop_ro(
          "start",
          [](const PythonBriefing& told) { return Place(told.briefing.start.cell.x, told.briefing.start.cell.y); },
          "The cell (x, y) in which the mouse starts; x counts eastwards and y northwards from (0, 0).")
      .def_prop_ro(
          "heading", [](const PythonBriefing& told) { return std::string(name_of(told.briefing.start.heading)); },
          "The direction that it faces there: 'north', 'east', 'south' or 'west'.")
      .def_prop_ro(
          "goals", [](const PythonBriefing& told) { return goals_of(told.briefing); }, "The goal cells.")
      .def_prop_ro(
          "world", [](const PythonBriefing& told) { return told.briefing.in_seconds() ? "seconds" : "steps"; },
          "'steps' or 'seconds'; in the physical world, too, it is 'seconds'.")
      .def_prop_ro(
          "stride",
          [](const PythonBriefing& told) {
            return told.briefing.in_seconds() ? max_drive_side : told.briefing.motion.longest;
          },
          "The longest movement of a step, in cells: 3 by the rules. In seconds 32, the largest side of a maze: there, "
          "a mouse may move along any straight that it has seen to be open.")
      .def_prop_ro(
          "budget",
          [](const PythonBriefing& told) {
            return told.briefing.in_seconds() ? std::nullopt : std::optional(told.briefing.budget);
          },
          "The number of steps that both runs may take together; None in seconds.")
      .def_prop_ro(
          "time_limit",
          [](const PythonBriefing& told) {
            const auto& drive = told.briefing.drive;
            return told.briefing.in_seconds() ? std::optional(static_cast<double>(drive.time_limit) / 1e6)
                                              : std::nullopt;
          },
          "The time limit in the maze, in seconds; None in steps.")
      .def_prop_ro(
          "sight", [](const PythonBriefing& told) { return told.briefing.sight; },
          "The range of the sensors in cells. A reading of this value means that no wall was seen within range.")
      .def_prop_ro(
          "seed", [](const PythonBriefing& told) { return told.briefing.seed; },
          "The seed for a stochastic mouse, below 2**64. The same contest always has the same seed.")
      .def("__getstate__", &fields_of)
      .def("__setstate__",
           [](PythonBriefing& told, const BriefingFields& fields) { new (&told) PythonBriefing(briefing_of(fields)); })
      .def("__repr__", [](const PythonBriefing& told) {
        const Briefing& briefing = told.briefing;
        return fmt::format("<labmouse.Briefing {}x{} from ({}, {}) {}, in {}>", briefing.size.width,
                           briefing.size.height, briefing.start.cell.x, briefing.start.cell.y,
                           name_of(briefing.start.heading), briefing.in_seconds() ? "seconds" : "steps");
      });
}

}  // namespace labmouse::python
