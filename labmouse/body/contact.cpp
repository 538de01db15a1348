#include "labmouse/body/contact.hpp"

#include <algorithm>
#include <cmath>

namespace labmouse {
namespace {

/// The chassis as it stands: its middle, its half sides, and how far it reaches along x and y.
struct Stand {
  Position middle;
  double half_length, half_width;
  double reach_x, reach_y;
};

Stand stand_of(const Chassis& chassis, const Position& position, const Direction& ahead) {
  const double half_length = (chassis.front + chassis.back) / 2.0, shift = (chassis.front - chassis.back) / 2.0;
  const double cosine = std::abs(ahead.cosine), sine = std::abs(ahead.sine);
  return {{position.x + shift * ahead.cosine, position.y + shift * ahead.sine},
          half_length,
          chassis.half_width,
          half_length * cosine + chassis.half_width * sine,
          half_length * sine + chassis.half_width * cosine};
}

void deepen(std::optional<Contact>& contact, const Contact& other) {
  if (!contact || other.depth > contact->depth) contact = other;
}

/// The line within half a wall of a coordinate, and how far beyond it that is.
struct NearLine {
  int line;
  double beyond;
};
std::optional<NearLine> near_line(const Field& field, double coordinate) {
  const int line = field.index_at(coordinate + field.cell() / 2.0);
  const double beyond = coordinate - line * field.cell();
  if (std::abs(beyond) > field.half_wall()) return std::nullopt;
  return NearLine{line, beyond};
}

/// A corner in a wall comes out towards the middle.
void touch_walls(const Field& field, const Position& corner, const Position& middle, std::optional<Contact>& contact) {
  const double half = field.half_wall();
  if (const auto near = near_line(field, corner.x)) {
    const int row = field.index_at(corner.y);
    if (field.stands({near->line, row}, Heading::west) || field.stands({near->line - 1, row}, Heading::east)) {
      const bool east = middle.x > corner.x;
      deepen(contact, {east ? Heading::east : Heading::west, half + (east ? -near->beyond : near->beyond),
                       wall_at({near->line, row}, Heading::west)});
    }
  }
  if (const auto near = near_line(field, corner.y)) {
    const int column = field.index_at(corner.x);
    if (field.stands({column, near->line}, Heading::south) || field.stands({column, near->line - 1}, Heading::north)) {
      const bool north = middle.y > corner.y;
      deepen(contact, {north ? Heading::north : Heading::south, half + (north ? -near->beyond : near->beyond),
                       wall_at({column, near->line}, Heading::south)});
    }
  }
}

/// A post in the chassis: two rectangles are apart where they are so along a side of either.
void touch_post(const Field& field, const Stand& stand, const Direction& ahead, std::optional<Contact>& contact) {
  const double cell = field.cell(), half = field.half_wall();
  const double x = stand.middle.x - field.index_at(stand.middle.x + cell / 2.0) * cell;
  const double y = stand.middle.y - field.index_at(stand.middle.y + cell / 2.0) * cell;
  const double deep_x = half + stand.reach_x - std::abs(x), deep_y = half + stand.reach_y - std::abs(y);
  if (deep_x <= 0.0 || deep_y <= 0.0) return;
  const double post = half * (std::abs(ahead.cosine) + std::abs(ahead.sine));
  const double along = std::abs(x * ahead.cosine + y * ahead.sine), aside = std::abs(y * ahead.cosine - x * ahead.sine);
  const double deep_along = post + stand.half_length - along, deep_aside = post + stand.half_width - aside;
  if (deep_along <= 0.0 || deep_aside <= 0.0) return;
  const bool across_x = deep_x < deep_y;
  const Heading out =
      across_x ? (x > 0.0 ? Heading::east : Heading::west) : (y > 0.0 ? Heading::north : Heading::south);
  deepen(contact, {out, std::min({deep_x, deep_y, deep_along, deep_aside}), std::nullopt});
}

/// Whether a stretch about a coordinate stays clear of all lines.
bool between_lines(const Field& field, double coordinate, double reach) {
  const double from = coordinate - field.index_at(coordinate) * field.cell() - field.half_wall();
  return from > reach && from < field.cell() - 2.0 * field.half_wall() - reach;
}

}  // namespace

std::optional<Contact> contact_of(const Field& field, const Chassis& chassis, const Position& position,
                                  const Direction& ahead) {
  const Stand stand = stand_of(chassis, position, ahead);
  if (between_lines(field, stand.middle.x, stand.reach_x) && between_lines(field, stand.middle.y, stand.reach_y))
    return std::nullopt;
  std::optional<Contact> contact;
  for (const double length : {stand.half_length, -stand.half_length})
    for (const double width : {stand.half_width, -stand.half_width})
      touch_walls(field,
                  {stand.middle.x + length * ahead.cosine - width * ahead.sine,
                   stand.middle.y + length * ahead.sine + width * ahead.cosine},
                  stand.middle, contact);
  touch_post(field, stand, ahead, contact);
  return contact;
}

}  // namespace labmouse
