// frontier: goes to the nearest unvisited cell.
//
// Limits: ignores where the goal is; follows dead ends to their end, and visits wide rooms cell by cell.
// Choices: ties go to the first cell in the order of a Python 3.4 map (MoveMapper). This reproduces all scores of the
// report.
#include <array>

#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/seeker.hpp"

namespace labmouse {
namespace {

class Frontier final : public Seeker {
 public:
  using Seeker::Seeker;

 private:
  int cost(const SearchTree& routes, Cell cell) const override { return routes.distance(cell); }
};

constexpr std::array frontier_parameters = {table_order};

}  // namespace

constinit const BuiltinMouse frontier_mouse = {
    .name = "frontier",
    .summary = "goes to the nearest cell that it has seen but not visited",
    .method =
        "Goes by the shortest route to the cell, among those seen but not visited, that takes the fewest moves to "
        "reach, and chooses again. When it enters the goal, it resets and takes the shortest route that it has seen.",
    .source = "FrontierBot in Edward Kish, section 4.5 (the third report).",
    .parameters = frontier_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Frontier>(briefing, settings);
    },
};

}  // namespace labmouse
