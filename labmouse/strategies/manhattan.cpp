// manhattan: to the cell that looks nearest to the goal.
//
// Method: among the cells that it has seen and not visited the one with the smallest Manhattan distance to a goal cell;
// one move on the shortest known route to it; then it chooses again. When it enters the goal it resets and takes the
// shortest route that it has seen.
// Limits: keeps crossing the maze where two regions near the goal are both closed to it, and seldom looks at the edge,
// where many a maze has its way in.
// Source: ManhattanBot in Edward Kish, section 4.4 (the third report).
// Choices: a visit is a step that ended in the cell, passing through is none; the target is chosen anew at each step;
// among equally near cells it takes the one seen first, and of one reading the directions in the tie order, in each the
// nearest first. No order gives the scores of the report; the default is among the nearest.
#include "labmouse/mouse/manhattan.hpp"

#include <array>
#include <vector>

#include "labmouse/mouse/seeker.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

class Manhattan final : public Seeker {
 public:
  Manhattan(const Briefing& briefing, const Settings& settings) : Seeker(briefing, TieOrder(settings.choice("ties"))) {
    seen_cells_.reserve(static_cast<std::size_t>(briefing.size.area()));
  }

 private:
  std::optional<Cell> choose() override {
    for (const Heading direction : ties().from(pose().heading)) note(direction);
    std::optional<Cell> nearest;
    int distance = unreachable;
    for (const Cell cell : seen_cells_) {
      if (visited().contains(cell)) continue;
      if (const int to_goal = manhattan_to(briefing().goals, cell); to_goal < distance) {
        distance = to_goal;
        nearest = cell;
      }
    }
    return nearest;
  }

  /// Adds the cells that are seen in a direction and were not before.
  void note(Heading direction) {
    Cell cell = pose().cell;
    while (knowledge().open().contains(wall_at(cell, direction))) {
      cell = neighbour(cell, direction);
      if (noted_.contains(cell)) continue;
      noted_.insert(cell);
      seen_cells_.push_back(cell);
    }
  }

  std::vector<Cell> seen_cells_;  ///< in the order in which they were seen
  CellSet noted_;                 ///< the same as a set
};

constexpr std::array parameters = {
    Parameter{"ties", ParameterType::choice, "wsen", 0, 0, TieOrder::all,
              "order of the directions in a reading and in the search for a route, by compass (nesw) or as the mouse "
              "faces (alrb)"},
};

}  // namespace

const RosterEntry manhattan_mouse = {
    "manhattan", "goes to the unvisited cell that looks nearest to the goal", parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Manhattan>(briefing, settings);
    }};

}  // namespace labmouse
