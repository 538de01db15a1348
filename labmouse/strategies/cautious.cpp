// cautious: one cell at a time, where it has been least.
//
// Limits: does not care where the goal is. Most of a share near 1 is spent on the search for the last cells; where
// cells are walled off such a share is never reached, and the budget ends.
// Choices: a visit is a step that ended in the cell, and the start is one; a neighbour behind is as good as any other
// and is entered backwards; the share counts all cells of the maze, also those never seen.
#include <array>

#include "labmouse/chance/dice.hpp"
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/known_moves.hpp"
#include "labmouse/mouse/visits.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

constexpr std::string_view method =
    "Moves one cell at a time, so that it passes nothing unseen: to a random unvisited neighbour, or, if it has "
    "visited all of them, to a random one of the least visited. Once it has entered the goal and visited a share of "
    "all cells, it resets and takes the shortest route that it has seen.";

constexpr std::string_view source = "CautiousBot in Edward Kish, section 4.3 (the third report).";

class Cautious final : public Explorer {
 public:
  Cautious(const Briefing& briefing, const Settings& settings)
      : Explorer(briefing),
        dice_(briefing.seed),
        visits_(briefing.size),
        cells_to_visit_(settings.real("explore_frac") * briefing.size.area()) {}

 private:
  Action explore() override {
    visits_.add(pose().cell);
    if (goal_entered() && visited().count() >= cells_to_visit_) return Action::reset();
    const KnownMoves moves(knowledge().open(), pose().cell, 1);
    // Nowhere to go: look at the wall behind.
    if (moves.empty()) return Action::step(90, 0);
    return move_in(pose().heading, least_visited(moves).direction, 1);
  }

  /// A move, of at least one, to a cell with the fewest visits, each equally likely.
  Move least_visited(const KnownMoves& moves) {
    std::array<Move, 4> best = {moves[0]};
    int count = 1, fewest = visits_after(moves[0]);
    for (int i = 1; i < moves.count(); ++i) {
      const int visits = visits_after(moves[i]);
      if (visits > fewest) continue;
      if (visits < fewest) count = 0;
      fewest = visits;
      best[static_cast<unsigned>(count++)] = moves[i];
    }
    return best[static_cast<unsigned>(dice_.below(count))];
  }

  int visits_after(const Move& move) const { return visits_.of(neighbour(pose().cell, move.direction)); }

  Dice dice_;
  Visits visits_;
  double cells_to_visit_;
};

constexpr std::array parameters = {
    Parameter{"explore_frac", ParameterType::real, "0", 0, 1, "", "share of all cells to visit before the reset"},
};

}  // namespace

constinit const RosterEntry cautious_mouse = {
    "cautious",
    "one cell a step, to a random one of the least visited neighbours",
    method,
    source,
    parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Cautious>(briefing, settings);
    },
    RosterEntry::always};

}  // namespace labmouse
