// What ariadne expects of the walls that it has not seen, as prices, and which kind of maze it takes this one for.
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

/// The price of an unseen wall for each reluctance of it; WallPrices::closed where it is taken for closed.
using PriceTable = std::array<std::uint8_t, 256>;

/// Keeps the prices of all walls of a maze in step with what is known.
class Outlook {
 public:
  /// Without a prior every unseen wall is as likely open as closed.
  Outlook(const Briefing& briefing, const WallPrior* prior);

  /// Learns what a reading shows, one that agrees with those before. True where it shows a wall that was unknown.
  bool learn(Pose pose, const Sighting& seen);
  /// Learns all that is known.
  bool learn(const Knowledge& knowledge);
  /// Prices all unseen walls anew, by a table that must live as long as it is in use.
  void price(const PriceTable& table);

  const WallPrices& prices() const { return prices_; }

  /// How much better a maze without loops explains the walls seen so far than one of a contest: the logarithm of the
  /// ratio of the likelihoods, in 1/32. 0 without a prior.
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
  WallSet rim_;     ///< about a goal room of 2×2 cells
  int rim_open_ = 0, rim_closed_ = 0;
  int evidence_ = 0;
};

}  // namespace labmouse::ariadne
