#include "labmouse/body/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace labmouse {
namespace {

/// The chassis as it stands: its middle, half the sides of the rectangle within its round corners, by how much it is
/// larger than that all round, and how far it reaches along x and y.
struct Placement {
  Position middle;
  double half_length, half_width, rounding;
  double reach_x, reach_y;
};

Placement stand_of(const Chassis& chassis, const Position& position, const Direction& ahead) {
  const double round = chassis.rounding;
  const double half_length = (chassis.front + chassis.back) / 2.0 - round, half_width = chassis.half_width - round;
  const double shift = (chassis.front - chassis.back) / 2.0;
  const double cosine = std::abs(ahead.cosine), sine = std::abs(ahead.sine);
  return {{position.x + shift * ahead.cosine, position.y + shift * ahead.sine},
          half_length,
          half_width,
          round,
          half_length * cosine + half_width * sine + round,
          half_length * sine + half_width * cosine + round};
}

void deepen(std::optional<Contact>& contact, const Contact& other) {
  if (!contact || other.depth > contact->depth) contact = other;
}

/// The grid lines across an axis whose walls may be in the range `coordinate` ± `reach`.
struct NearLines {
  int first, last;

  bool none() const { return first > last; }
};
NearLines near_lines(const Field& field, double coordinate, double reach) {
  const double far = reach + field.half_wall() + field.most_shift();
  return {field.index_at(coordinate - far) + 1, field.index_at(coordinate + far)};
}

/// A quick check that holds in most ticks: it is between the lines of one axis, and those of the other are open where
/// it crosses them.
bool is_free(const Field& field, const Position& middle, const NearLines& x, const NearLines& y) {
  if (!x.none() && !y.none()) return false;
  const int column = field.index_at(middle.x), row = field.index_at(middle.y);
  for (int line = x.first; line <= x.last; ++line)
    if (field.stands_upright(line, row)) return false;
  for (int line = y.first; line <= y.last; ++line)
    if (field.stands_level(column, line)) return false;
  return true;
}

/// Adds the contact of a corner with walls; of a round one, the centre of its arc is given. The way out is towards the
/// middle of the chassis; a centre can be that middle, and then it is to the side of the wall on which this is.
void touch_walls(const Field& field, const Position& corner, const Placement& stand, const NearLines& x,
                 const NearLines& y, std::optional<Contact>& contact) {
  const Position& middle = stand.middle;
  const double half = field.half_wall() + stand.rounding;
  for (int line = x.first; line <= x.last; ++line) {
    const double beyond = corner.x - line * field.cell() - field.upright_shift(line, corner.y);
    const int row = field.index_at(corner.y);
    if (std::abs(beyond) > half || !field.stands_upright(line, row)) continue;
    const bool east = middle.x > (stand.rounding > 0.0 ? corner.x - beyond : corner.x);
    deepen(contact, {east ? Heading::east : Heading::west, half + (east ? -beyond : beyond),
                     wall_at({line, row}, Heading::west)});
  }
  for (int line = y.first; line <= y.last; ++line) {
    const double beyond = corner.y - line * field.cell() - field.level_shift(corner.x, line);
    const int column = field.index_at(corner.x);
    if (std::abs(beyond) > half || !field.stands_level(column, line)) continue;
    const bool north = middle.y > (stand.rounding > 0.0 ? corner.y - beyond : corner.y);
    deepen(contact, {north ? Heading::north : Heading::south, half + (north ? -beyond : beyond),
                     wall_at({column, line}, Heading::south)});
  }
}

/// The square of the distance of a point from a rectangle about the origin with these half sides.
double squared_distance(double x, double y, double half_x, double half_y) {
  const double beyond_x = std::max(0.0, std::abs(x) - half_x), beyond_y = std::max(0.0, std::abs(y) - half_y);
  return beyond_x * beyond_x + beyond_y * beyond_y;
}

/// The distance of the rectangle within the round corners from a post, of which its middle is (x, y) away: that of a
/// corner of one from the other. 0 if it is on the post.
double distance_of(const Placement& stand, const Direction& ahead, double half, double x, double y) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double one : {-1.0, 1.0})
    for (const double other : {-1.0, 1.0}) {
      const double along = one * stand.half_length, aside = other * stand.half_width;
      const double post_x = one * half - x, post_y = other * half - y;
      nearest = std::min(
          {nearest,
           squared_distance(x + along * ahead.cosine - aside * ahead.sine,
                            y + along * ahead.sine + aside * ahead.cosine, half, half),
           squared_distance(post_x * ahead.cosine + post_y * ahead.sine, post_y * ahead.cosine - post_x * ahead.sine,
                            stand.half_length, stand.half_width)});
    }
  return std::sqrt(nearest);
}

/// Adds the contact with a post. Two rectangles are apart if they are separated along a side of either.
void touch_post(const Field& field, const Placement& stand, const Direction& ahead, const Position& post,
                std::optional<Contact>& contact) {
  const double half = field.half_wall();
  const double x = stand.middle.x - post.x, y = stand.middle.y - post.y;
  const double deep_x = half + stand.reach_x - std::abs(x), deep_y = half + stand.reach_y - std::abs(y);
  if (deep_x <= 0.0 || deep_y <= 0.0) return;
  const double turned_half = half * (std::abs(ahead.cosine) + std::abs(ahead.sine)) + stand.rounding;
  const double along = std::abs(x * ahead.cosine + y * ahead.sine), aside = std::abs(y * ahead.cosine - x * ahead.sine);
  const double deep_along = turned_half + stand.half_length - along;
  const double deep_aside = turned_half + stand.half_width - aside;
  if (deep_along <= 0.0 || deep_aside <= 0.0) return;
  const bool across_x = deep_x < deep_y;
  const Heading out =
      across_x ? (x > 0.0 ? Heading::east : Heading::west) : (y > 0.0 ? Heading::north : Heading::south);
  double depth = std::min({deep_x, deep_y, deep_along, deep_aside});
  if (stand.rounding > 0.0) {
    const double distance = distance_of(stand, ahead, half, x, y);
    if (distance >= stand.rounding) return;
    if (distance > 0.0) depth = std::min(depth, stand.rounding - distance);
  }
  deepen(contact, {out, depth, std::nullopt});
}

}  // namespace

std::optional<Contact> contact_of(const Field& field, const Chassis& chassis, const Position& position,
                                  const Direction& ahead) {
  const Placement stand = stand_of(chassis, position, ahead);
  const NearLines x = near_lines(field, stand.middle.x, stand.reach_x);
  const NearLines y = near_lines(field, stand.middle.y, stand.reach_y);
  if (is_free(field, stand.middle, x, y)) return std::nullopt;
  std::optional<Contact> contact;
  for (const double length : {stand.half_length, -stand.half_length})
    for (const double width : {stand.half_width, -stand.half_width})
      touch_walls(field,
                  {stand.middle.x + length * ahead.cosine - width * ahead.sine,
                   stand.middle.y + length * ahead.sine + width * ahead.cosine},
                  stand, x, y, contact);
  for (int column = x.first; column <= x.last; ++column)
    for (int row = y.first; row <= y.last; ++row)
      touch_post(field, stand, ahead,
                 Position{column * field.cell(), row * field.cell()} + field.post_shift(column, row), contact);
  return contact;
}

}  // namespace labmouse
