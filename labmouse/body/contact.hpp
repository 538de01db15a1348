// Contacts of a mouse with walls and posts.
//
// Its chassis is a rectangle, whose corners can be round. It meets a wall with one of its corners, and a post with a
// corner or a side.
#pragma once

#include <optional>

#include "labmouse/body/field.hpp"
#include "labmouse/functions/angles.hpp"
#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// A contact: the heading in which the mouse gets out of it, its depth in mm, and the wall; no wall if a post is
/// touched.
struct Contact {
  Heading out = Heading::north;
  double depth = 0.0;
  std::optional<Wall> wall;
};

/// The deepest contact of a chassis in that position and direction; nothing without one.
std::optional<Contact> contact_of(const Field& field, const Chassis& chassis, const Position& position,
                                  const Direction& ahead);

}  // namespace labmouse
