#include "briefing.hpp"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"

namespace nb = nanobind;

namespace labmouse::python {

void bind_briefings(nb::module_& module) {
  using Place = std::pair<int, int>;
  nb::class_<PythonBriefing>(module, "Briefing", "What a mouse is told of its contest before it is put into the maze.")
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
          "Where it looks there: 'north', 'east', 'south' or 'west'.")
      .def_prop_ro(
          "goals",
          [](const PythonBriefing& told) {
            std::vector<Place> goals;
            told.briefing.goals.for_each([&](Cell cell) { goals.emplace_back(cell.x, cell.y); });
            return goals;
          },
          "The goal cells.")
      .def_prop_ro(
          "stride", [](const PythonBriefing& told) { return told.briefing.motion.longest; },
          "The longest movement of a step, in cells.")
      .def_prop_ro(
          "budget", [](const PythonBriefing& told) { return told.briefing.budget; },
          "Steps that both runs may take together.")
      .def_prop_ro(
          "seed", [](const PythonBriefing& told) { return told.briefing.seed; },
          "For a mouse that throws dice: the same contest always has the same seed; below 2**64.");
}

}  // namespace labmouse::python
