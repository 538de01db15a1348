// Prices of unseen walls by their probability of being closed, and the evidence for a maze without loops.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/sighting.hpp"
#include "labmouse/mouse/wall_contexts.hpp"
#include "labmouse/mouse/wall_prices.hpp"
#include "labmouse/mouse/wall_prior.hpp"

namespace labmouse::ariadne {

/// Price of an unseen wall by its reluctance (-ln P(open) in 1/32); WallPrices::closed if it counts as closed.
using PriceTable = std::array<std::uint8_t, 256>;

/// Prices of all walls of a maze, updated with each reading.
class Outlook {
 public:
  /// Without a prior every unseen wall is open with probability 1/2.
  Outlook(const Briefing& briefing, const WallPrior* prior);

  /// Adds a reading, which must agree with earlier ones. Returns whether it shows an unknown wall.
  bool learn(Pose pose, const Sighting& seen);
  /// Adds all known walls. Returns whether one of them was unknown.
  bool learn(const Knowledge& knowledge);
  /// Computes the prices of all unseen walls from a table, which must outlive its use.
  void price(const PriceTable& table);

  const WallPrices& prices() const { return prices_; }

  /// Log-likelihood ratio of the seen walls, in 1/32 nat: a maze without loops against a contest maze. 0 without a
  /// prior.
  int evidence_against_loops() const { return evidence_; }

 private:
  void learn(Wall wall, bool open);
  void weigh(Wall wall, bool open);
  void price(Wall wall);
  /// -ln P(open) of an unseen wall, in 1/32.
  int reluctance(Wall wall) const;

  Size size_;
  int sight_;
  const WallPrior* prior_;
  const PriceTable* table_;
  WallContexts contexts_;
  WallPrices prices_;
  WallSet unknown_;
  WallSet inside_;  ///< between two goal cells
  WallSet rim_;     ///< around a goal room of 2×2 cells
  int rim_open_ = 0, rim_closed_ = 0;
  int evidence_ = 0;
};

}  // namespace labmouse::ariadne
