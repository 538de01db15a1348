// The order in which a strategy tries the four directions on a tie.
#pragma once

#include <array>
#include <cassert>
#include <string_view>

#include "labmouse/grid/heading.hpp"

namespace labmouse {

/// An order of the four directions: by the compass (`nesw`) or as the mouse faces (`alrb`: ahead, left, right, back).
class TieOrder {
 public:
  /// Every order there is, separated by `/`, as a parameter's choices are.
  static constexpr std::string_view all =
      "nesw/news/nsew/nswe/nwes/nwse/ensw/enws/esnw/eswn/ewns/ewsn/"
      "snew/snwe/senw/sewn/swne/swen/wnes/wnse/wens/wesn/wsne/wsen/"
      "alrb/albr/arlb/arbl/ablr/abrl/larb/labr/lrab/lrba/lbar/lbra/"
      "ralb/rabl/rlab/rlba/rbal/rbla/balr/barl/blar/blra/bral/brla";

  /// The order of that name, which must be one of all.
  explicit constexpr TieOrder(std::string_view name) {
    assert(name.size() == 4);
    for (unsigned place = 0; place < 4; ++place) {
      const auto quarters = std::string_view("nesw").find(name[place]);
      relative_ = relative_ || quarters == std::string_view::npos;
    }
    for (unsigned place = 0; place < 4; ++place)
      quarters_[place] = static_cast<int>(std::string_view(relative_ ? "arbl" : "nesw").find(name[place]));
  }

  /// The headings in this order, for a mouse that faces `facing`.
  constexpr std::array<Heading, 4> from(Heading facing) const {
    std::array<Heading, 4> headings{};
    for (unsigned place = 0; place < 4; ++place)
      headings[place] = turned(relative_ ? facing : Heading::north, quarters_[place]);
    return headings;
  }

 private:
  bool relative_ = false;
  std::array<int, 4> quarters_{};
};

}  // namespace labmouse
