// What the wandering mice share: random-move, dead-end and visit-counter.
//
// They walk until they have entered a goal and stood in a share of all cells, know only the walls about the cells in
// which they stood, and plan the speed run once, at its start, by a textbook's search over those.
// Source: the fifth report, "Plot and Navigate a Virtual Maze", whose explorers have one base for this.
#pragma once

#include <array>
#include <vector>

#include "labmouse/chance/dice.hpp"
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/near_walls.hpp"
#include "labmouse/mouse/textbook_search.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// The parameter of those that move by chance alone: with a larger share they hardly ever end in time.
inline constexpr Parameter half_coverage = {
    "coverage", ParameterType::real, "0.5", 0, 1, "", "share of all cells to stand in before the reset"};

/// A mouse that wanders. A mind derives from it and writes wander().
class Wanderer : public Explorer {
 public:
  /// `coverage` is the share of all cells to stand in.
  Wanderer(const Briefing& briefing, double coverage, SearchMethod method, TieOrder order);

  /// Of the search for the speed run, once it is planned.
  std::span<const Counter> counters() const final;

 protected:
  /// One step of the exploration.
  virtual Action wander() = 0;

  /// A turn by -90, 0 or 90 degrees and a movement of no to the most cells, drawn again while a wall is in the way.
  Action random_step();
  Dice& dice() { return dice_; }

 private:
  Action explore() final;
  Action race() final;
  void plan();

  Dice dice_;
  double cells_to_visit_;
  NearWalls near_walls_;
  TextbookSearch search_;
  std::vector<Move> moves_;
  std::size_t next_move_ = 0;
  std::array<Counter, 2> counters_{};
  bool planned_ = false;
};

}  // namespace labmouse
