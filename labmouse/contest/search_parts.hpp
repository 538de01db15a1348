// Splits a search move over several edges into parts. The mouse reads the walls at the end of each part.
#pragma once

#include <optional>

#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

/// The first part of a move: to rest, over one edge, or a dash over known cells.
inline Action first_part(const SearchDrive& drive, const SearchPlace& from, const Action& move,
                         const Knowledge& known) {
  if (move.movement <= 1 || move.rotation != 0 || from.at_rest)
    return Action::step(move.rotation, move.movement == 0 ? 0 : 1);
  return Action::step(0, dash_length(drive, from.pose, move.movement, [&](Cell cell) { return known.knows(cell); }));
}

/// The first wall on the way of a part that is not known to be open, if there is one.
inline std::optional<Wall> wall_not_open(const SearchPlace& from, const Action& part, const Knowledge& known) {
  const Heading heading = after_search(from, part).pose.heading;
  for (int cell = 0; cell < part.movement; ++cell)
    if (const Wall wall = wall_at(neighbour(from.pose.cell, heading, cell), heading); !known.open().contains(wall))
      return wall;
  return std::nullopt;
}

}  // namespace labmouse
