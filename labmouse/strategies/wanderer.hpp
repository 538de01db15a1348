// Base of the random explorers: random-move, dead-end and visit-counter.
//
// They walk cell by cell, and mark a cell only when they draw a random turn in it. Once a goal and a share of all cells
// are marked, they reset, and plan the speed run by a textbook search over the passages that they walked.
// Source: the fifth report, "Plot and Navigate a Virtual Maze", and its program.
#pragma once

#include <array>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/textbook_search.hpp"
#include "labmouse/mouse/walked_passages.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

inline constexpr Parameter wanderers_coverage =
    Parameter::real("coverage", "0.8333", 0, 1, "Share of all cells to mark before the reset.");

inline constexpr Parameter wanderers_search = Parameter::choice("search", "a-star", "breadth-first/a-star/dijkstra",
                                                                "Search algorithm that plans the speed run.");

/// A random explorer with the parameters above. Strategies derive from it and define wander().
class Wanderer : public Explorer {
 public:
  Wanderer(const Briefing& briefing, const Settings& settings);

  /// Counters of the search for the speed run, once it is planned.
  StrategyReport report() final;

 protected:
  /// One step of the search run, of at most one cell.
  virtual Action wander() = 0;

  /// Draws a turn of -1, 0 or 1 quarters with equal probability, regardless of walls. Marks the present cell.
  int draw();
  /// Draws until the way is free, and goes there. At least one way must be free.
  Action draw_a_free_cell();
  bool is_free(int quarters) const { return seen().towards(quarters) > 0; }
  /// Whether walls are to the left, ahead and to the right.
  bool in_dead_end() const { return seen() == Sighting{0, 0, 0}; }
  Rng& rng() { return rng_; }

 private:
  Action explore() final;
  Action race() final;
  void plan();

  Rng rng_;
  double cells_to_mark_;
  CellSet marked_;
  bool goal_marked_ = false;
  WalkedPassages passages_;
  TextbookSearch search_;
  std::vector<Move> moves_;
  std::size_t next_move_ = 0;
  std::array<Counter, 1> counters_{};
  bool planned_ = false;
};

}  // namespace labmouse
