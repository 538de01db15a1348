// frontier: to the nearest cell that it has not visited.
//
// Method: among the cells that it has seen and not visited the one that takes the fewest moves to reach; one move on
// the shortest known route to it; then it chooses again. When it enters the goal it resets and takes the shortest route
// that it has seen.
// Limits: does not care where the goal is; follows long dead ends to their end, and takes wide rooms cell by cell.
// Source: FrontierBot in Edward Kish, section 4.5 (the third report).
// Choices: an unknown cell is one that was seen, but neither entered nor passed; the target is chosen anew at each
// step; among equally near ones it takes the one that lies farthest in the first direction of the tie order, then in
// the next: by default the westernmost, then the southernmost. No reading gives the scores of the report; this one is
// the nearest.
#include <array>

#include "labmouse/mouse/seeker.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

class Frontier final : public Seeker {
 public:
  Frontier(const Briefing& briefing, const Settings& settings)
      : Seeker(briefing, TieOrder(settings.choice("ties"))), last_(briefing.start.cell) {}

 private:
  std::optional<Cell> choose() override {
    enter(pose().cell);
    std::optional<Cell> nearest;
    for (const Cell cell : routes().found())
      if (!entered_.contains(cell) && (!nearest || comes_before(cell, *nearest))) nearest = cell;
    return nearest;
  }

  /// Marks the cell in which the mouse stands and those that its last move passed.
  void enter(Cell here) {
    if (here != last_) {
      const Move move = move_between(last_, here);
      for (int cells = 1; cells < move.cells; ++cells) entered_.insert(neighbour(last_, move.direction, cells));
    }
    entered_.insert(here);
    last_ = here;
  }

  bool comes_before(Cell a, Cell b) const {
    const int moves_to_a = routes().distance(a), moves_to_b = routes().distance(b);
    if (moves_to_a != moves_to_b) return moves_to_a < moves_to_b;
    for (const Heading direction : ties().from(pose().heading)) {
      const Cell step = neighbour({}, direction);
      if (const int lead = (a.x - b.x) * step.x + (a.y - b.y) * step.y; lead != 0) return lead > 0;
    }
    return false;
  }

  CellSet entered_;
  Cell last_;  ///< where the last step ended
};

constexpr std::array parameters = {
    Parameter{
        "ties", ParameterType::choice, "wsen", 0, 0, TieOrder::all,
        "order of the directions among cells that are equally near, by compass (nesw) or as the mouse faces (alrb)"},
};

}  // namespace

const RosterEntry frontier_mouse = {
    "frontier", "goes to the nearest cell that it has seen and not visited", parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Frontier>(briefing, settings);
    }};

}  // namespace labmouse
