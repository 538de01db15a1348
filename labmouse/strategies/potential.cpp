// potential: moves to the cell of lowest potential, and raises that of visited cells.
//
// Limits: it never gives up, even if no way leads to the goal, and does not know what is still unexplored.
// Choices: as the report's program does it. A cell's first potential is its distance to the nearest column of the goal
// plus that to the nearest row; where all three readings are 0 it becomes twice the maze's side; where more than one
// known move leads away it is doubled at each visit, even in a dead end. It moves to the lowest of the cells that one
// known move leads to, including backwards; ties go to the first in the order of a Python 3.4 set (MoveMapper).
#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/move_mapper.hpp"

namespace labmouse {
namespace {

class Potential final : public MoveMapper {
 public:
  Potential(const Briefing& briefing, const Settings& settings)
      : MoveMapper(briefing, settings), potential_(static_cast<std::size_t>(briefing.size.area())) {
    for (int index = 0; index < briefing.size.area(); ++index) {
      const Cell cell = briefing.size.cell_at(index);
      int columns = max_side, rows = max_side;
      briefing.goals.for_each([&](Cell goal) {
        columns = std::min(columns, std::abs(cell.x - goal.x));
        rows = std::min(rows, std::abs(cell.y - goal.y));
      });
      potential(cell) = columns + rows;
    }
  }

 private:
  Action choose() override {
    const auto cells = map().of(pose().cell);
    // No known move: turn to see the wall behind.
    if (cells.empty()) return Action::step(90, 0);
    if (seen() == Sighting{0, 0, 0})
      potential(pose().cell) = 2.0 * std::max(briefing().size.width, briefing().size.height);
    if (cells.size() > 1) potential(pose().cell) *= 2.0;
    return go_to(
        *std::min_element(cells.begin(), cells.end(), [&](Cell a, Cell b) { return potential(a) < potential(b); }));
  }

  double& potential(Cell cell) { return potential_[static_cast<std::size_t>(briefing().size.index(cell))]; }

  std::vector<double> potential_;  ///< whole numbers, exact as long as they are finite
};

constexpr std::array potential_parameters = {table_order};

}  // namespace

constinit const BuiltinMouse potential_mouse = {
    .name = "potential",
    .summary = "goes where the potential is lowest; visits and dead ends raise it",
    .method =
        "Each cell has a potential, at first its distance to the goal in columns and rows. A dead end takes twice the "
        "maze's side. A cell from which several known moves lead is doubled at each visit. At each step the mouse "
        "moves to the cell of lowest potential that one known move leads to. When it enters the goal it resets and "
        "takes the shortest route that it has seen.",
    .source = "PotentialBot in Edward Kish, section 4.6 (the third report), after Wyard-Scott and Meng 1995.",
    .parameters = potential_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Potential>(briefing, settings);
    },
};

}  // namespace labmouse
