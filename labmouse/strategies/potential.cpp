// potential: rolls downhill to the goal and raises the ground behind it.
//
// Limits: it never gives up, also where no way leads to the goal; nothing tells it which routes are left to see.
// Choices: the goal is its first cell, row by row from the south-west; a dead end is where the mouse sees no way, and
// then it turns on the spot, to the right; otherwise it looks at the cells to the left, ahead and to the right, never
// behind; free directions count the one that it came from; among equals the first in the tie order, in one direction
// the nearest. To double at each visit instead is farther from the scores of the report, and no order gives them all.
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/manhattan.hpp"
#include "labmouse/mouse/route.hpp"
#include "labmouse/mouse/tie_order.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

constexpr std::string_view method =
    "Each cell has a potential, initially its Manhattan distance to the goal. A dead end gets the largest one. Each "
    "visit to a cell with several free directions raises its potential by its initial value, so the first visit "
    "doubles it. At each step the mouse moves to the cell of lowest potential that it sees within one move. When it "
    "enters the goal, it resets and takes the shortest route that it has seen.";

constexpr std::string_view source =
    "PotentialBot in Edward Kish, section 4.6 (the third report), after Wyard-Scott and Meng 1995.";

class Potential final : public Explorer {
 public:
  Potential(const Briefing& briefing, const Settings& settings)
      : Explorer(briefing),
        ties_(settings.choice("ties")),
        goal_(first(briefing.goals)),
        potential_(static_cast<std::size_t>(briefing.size.area())) {
    for (int index = 0; index < briefing.size.area(); ++index)
      potential_[static_cast<std::size_t>(index)] = manhattan(briefing.size.cell_at(index), goal_);
  }

 private:
  static constexpr int largest = std::numeric_limits<int>::max();

  static Cell first(const CellSet& cells) {
    std::optional<Cell> first;
    cells.for_each([&](Cell cell) { first = first.value_or(cell); });
    return *first;
  }

  Action explore() override {
    if (goal_entered()) return Action::reset();
    // Standing on a goal without having entered it: the start is one. A step has to end there.
    if (briefing().goals.contains(pose().cell)) return Action::step(0, 0);
    raise();
    const Move move = downhill();
    return move.cells > 0 ? move_in(pose().heading, move.direction, move.cells) : Action::step(90, 0);
  }

  /// Raises the potential of the cell in which the mouse stands.
  void raise() {
    int& here = potential(pose().cell);
    if (seen() == Sighting{0, 0, 0})
      here = largest;
    else if (here != largest && free_directions() > 1)
      here += manhattan(pose().cell, goal_);
  }

  int free_directions() const {
    int count = 0;
    for (const Heading direction : all_headings)
      if (knowledge().open().contains(wall_at(pose().cell, direction))) ++count;
    return count;
  }

  /// The move to the cell of lowest potential among those in sight; one of no cells where none is.
  Move downhill() {
    Move best;
    int lowest = 0;
    for (const Heading direction : ties_.from(pose().heading)) {
      if (direction == opposite(pose().heading)) continue;
      for (int cells = 1; cells <= cells_open(direction); ++cells) {
        const int there = potential(neighbour(pose().cell, direction, cells));
        if (best.cells > 0 && there >= lowest) continue;
        best = {direction, cells};
        lowest = there;
      }
    }
    return best;
  }

  /// How far one move leads in a direction other than back.
  int cells_open(Heading direction) const {
    const int quarters = quarters_between(pose().heading, direction);
    return std::min(seen().towards(quarters == 3 ? -1 : quarters), briefing().motion.longest);
  }

  int& potential(Cell cell) { return potential_[static_cast<std::size_t>(briefing().size.index(cell))]; }

  TieOrder ties_;
  Cell goal_;
  std::vector<int> potential_;
};

constexpr std::array parameters = {
    Parameter{"ties", ParameterType::choice, "snwe", 0, 0, TieOrder::all,
              "order of the directions among equal potentials, by compass (nesw) or as the mouse faces (alrb)"},
};

}  // namespace

constinit const RosterEntry potential_mouse = {
    "potential",
    "goes where the potential is lowest; visits and dead ends raise it",
    method,
    source,
    parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Potential>(briefing, settings);
    }};

}  // namespace labmouse
