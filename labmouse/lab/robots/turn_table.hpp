// Turns of a robot as published or measured, in a table of text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/maze/formats/read_result.hpp"
#include "labmouse/mouse/robot/turn.hpp"

namespace labmouse {

/// One of them; what the table does not say is 0.
struct KnownTurn {
  Turn turn = Turn::f45;
  bool wide = false;          ///< K90: as V90 in cells of twice the size
  double speed = 0.0;         ///< mm/s, all along it
  double milliseconds = 0.0;  ///< of the whole turn, from node to node
  double aside = 0.0;         ///< mm from the beginning of its curve to the end, across the direction of its beginning
  double before = 0.0;        ///< mm of straight before the curve

  std::string_view name() const { return wide ? "K90" : name_of(turn); }
};

/// Turns, or what is wrong with their table: exactly one of the two is there.
struct TurnTable {
  std::vector<KnownTurn> turns;
  std::vector<Problem> problems;
};

/// Reads columns between blanks, tabs or commas, of which the first line has the names: `turn`, and any of `speed`
/// (mm/s), `ms`, `x` and `y` (mm, of the curve; x is not needed), `before` and `after` (mm of straight; after is not
/// needed). "-" is no value. Lines that begin with # and empty ones say nothing.
TurnTable read_turn_table(std::string_view text);

}  // namespace labmouse
