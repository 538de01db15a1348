#include "labmouse/body/beams.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/exponential.hpp"
#include "labmouse/functions/normal.hpp"
#include "labmouse/hardware/beam.hpp"

namespace labmouse {
namespace {

constexpr int strengths_a_mm = 4;

/// What comes back where light does not meet a wall almost at a right angle.
double slant(double cosine) { return cosine < 0.9 ? cosine / 0.9 : 1.0; }

}  // namespace

Beams::Beams(const Field& field, const Sensors& sensors, const Specimen& specimen)
    : field_(field), sensors_(sensors), specimen_(specimen) {
  const Infrared& infrared = sensors.infrared;
  double farthest = 0.0;
  for (std::size_t beam = 0; beam < beam_count; ++beam) {
    directions_[beam] = direction_of(infrared.beams[beam].angle);
    calibrated_[beam] = calibrated_distance(infrared.beams[beam], field.cell());
    // In strengths from the sensor on, not from the calibrated place.
    gains_[beam] = infrared.gain * specimen.infrared[beam] * exp_of(calibrated_[beam] / infrared.fall);
    // Farther than that a whole wall comes back as less than half a count.
    farthest = std::max(farthest, infrared.fall * log_of(2.0 * std::max(1.0, gains_[beam])));
  }
  const auto count = static_cast<std::size_t>(farthest * strengths_a_mm) + 2;
  for (std::size_t i = 0; i < count; ++i)
    strengths_.push_back(exp_of(-static_cast<double>(i) / strengths_a_mm / infrared.fall));
}

double Beams::strength_at(double distance) const {
  const double step = distance * strengths_a_mm;
  const auto index = static_cast<std::size_t>(step);
  if (index + 1 >= strengths_.size()) return 0.0;
  return strengths_[index] + (step - static_cast<double>(index)) * (strengths_[index + 1] - strengths_[index]);
}

/// Calls visit(crossing) for the lines that a ray meets, the nearest first, until it returns false or the maze ends.
template <class Visit>
void Beams::for_each_crossing(const Ray& ray, Visit visit) const {
  const double cell = field_.cell(), half = field_.half_wall();
  const auto& [sine, cosine] = ray.direction;
  constexpr double never = 1e9, least = 1e-6;
  // Of the faces across x and those across y: the side that the ray meets, the line's number, and its distance.
  const bool east = cosine > 0.0, north = sine > 0.0;
  const double slow_x = std::max(std::abs(cosine), least), slow_y = std::max(std::abs(sine), least);
  int column = field_.index_at(east ? ray.from.x + half : ray.from.x - half);
  int row = field_.index_at(north ? ray.from.y + half : ray.from.y - half);
  const auto to_x = [&] {
    return (east ? (column + 1) * cell - half - ray.from.x : ray.from.x - column * cell - half) / slow_x;
  };
  const auto to_y = [&] {
    return (north ? (row + 1) * cell - half - ray.from.y : ray.from.y - row * cell - half) / slow_y;
  };
  double x = slow_x > least ? to_x() : never, y = slow_y > least ? to_y() : never;
  for (;;) {
    Crossing crossing;
    if (x < y) {
      const double along = ray.from.y + x * sine;
      const int other = field_.index_at(along);
      crossing = {x, slow_x, {column, other}, east ? Heading::east : Heading::west, along - other * cell};
    } else {
      const double along = ray.from.x + y * cosine;
      const int other = field_.index_at(along);
      crossing = {y, slow_y, {other, row}, north ? Heading::north : Heading::south, along - other * cell};
    }
    if (!field_.contains(crossing.cell) || !visit(crossing)) return;
    if (x < y) {
      column += east ? 1 : -1;
      x = to_x();
    } else {
      row += north ? 1 : -1;
      y = to_y();
    }
  }
}

/// What of a beam's spot lies on walls and posts.
///
///      below       along                       above
///      ---o=========o---          posts o, the side's wall =, its neighbours -
///         0        cell
double Beams::share_of(const Crossing& crossing) const {
  const double cell = field_.cell(), half = field_.half_wall(), along = crossing.along;
  const double deviation = sensors_.infrared.footprint / crossing.cosine;
  const double reach = NormalShare::reach * deviation;
  const bool stands = field_.stands(crossing.cell, crossing.side);
  const bool low = along - half<reach, high = along + half> cell - reach;
  if (!low && !high) return stands ? 1.0 : 0.0;
  const bool upright = crossing.side == Heading::east || crossing.side == Heading::west;
  const Heading onwards = upright ? Heading::north : Heading::east;
  const auto below = [&](double point) { return NormalShare::below((point - along) / deviation); };
  double share = stands ? 1.0 : 0.0;
  if (low) {
    const bool more = field_.stands(neighbour(crossing.cell, onwards, -1), crossing.side);
    // The wall's side of the post is there if either of them is.
    share += (stands ? 0.0 : below(half)) - (more ? 0.0 : below(-half));
  }
  if (high) {
    const bool more = field_.stands(neighbour(crossing.cell, onwards), crossing.side);
    share += (stands ? 0.0 : 1.0 - below(cell - half)) - (more ? 0.0 : 1.0 - below(cell + half));
  }
  return std::clamp(share, 0.0, 1.0);
}

double Beams::level(std::size_t beam, const Position& position, const Direction& ahead) const {
  const Beam& at = sensors_.infrared.beams[beam];
  const Direction& own = directions_[beam];
  const Ray ray = {
      {position.x + at.ahead * ahead.cosine - at.aside * ahead.sine,
       position.y + at.ahead * ahead.sine + at.aside * ahead.cosine},
      {ahead.sine * own.cosine + ahead.cosine * own.sine, ahead.cosine * own.cosine - ahead.sine * own.sine}};
  double level = 0.0, passing = 1.0;
  for_each_crossing(ray, [&](const Crossing& crossing) {
    const double strength = strength_at(crossing.distance);
    if (strength <= 0.0) return false;
    const double share = share_of(crossing);
    if (share > 0.0) {
      level += passing * share * gains_[beam] * strength * slant(crossing.cosine) *
               specimen_.reflectance(crossing.cell, crossing.side);
      passing *= 1.0 - share;
    }
    return passing > 0.02;
  });
  return std::min(level, sensors_.infrared.most);
}

double Beams::range(const Position& position, const Direction& ahead) const {
  const Ranger& ranger = sensors_.ranger;
  const Ray ray = {{position.x + ranger.ahead * ahead.cosine, position.y + ranger.ahead * ahead.sine}, ahead};
  const double cell = field_.cell(), half = field_.half_wall();
  double range = 0.0;
  for_each_crossing(ray, [&](const Crossing& crossing) {
    if (crossing.distance > ranger.reach) return false;
    const bool post = crossing.along < half || crossing.along > cell - half;
    if (!post && !field_.stands(crossing.cell, crossing.side)) return true;
    range = std::max(0.0, crossing.distance);
    return false;
  });
  return range;
}

}  // namespace labmouse
