#include "labmouse/body/beams.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/exponential.hpp"
#include "labmouse/functions/normal.hpp"
#include "labmouse/hardware/beam.hpp"

namespace labmouse {
namespace {

/// The grid lines across one axis that a ray meets, one after the other.
struct Lines {
  double next;     ///< distance to the face of the first of them
  double between;  ///< from one to the next
  double cosine;   ///< of the ray's angle of incidence
  int cell;        ///< the column or row before that line
  int step;        ///< to the one behind it
};

Lines lines_of(const Field& field, double from, double way) {
  // A ray along the lines never meets one.
  constexpr double least = 1e-6, never = 1e9;
  const double cell = field.cell(), half = field.half_wall(), cosine = std::abs(way);
  const bool up = way > 0.0;
  const int index = field.index_at(up ? from + half : from - half);
  if (cosine < least) return {never, never, cosine, index, 1};
  const double per_way = 1.0 / cosine;
  const double gap = up ? (index + 1) * cell - half - from : from - index * cell - half;
  return {gap * per_way, cell * per_way, cosine, index, up ? 1 : -1};
}

/// The ray of a sensor that looks in the direction `own`, relative to ahead.
Ray ray_of(const Beam& at, const Direction& own, const Position& position, const Direction& ahead) {
  return {{position.x + at.ahead * ahead.cosine - at.aside * ahead.sine,
           position.y + at.ahead * ahead.sine + at.aside * ahead.cosine},
          {ahead.sine * own.cosine + ahead.cosine * own.sine, ahead.cosine * own.cosine - ahead.sine * own.sine}};
}

}  // namespace

Beams::Beams(const Field& field, const Sensors& sensors, const RobotSample& robot_sample)
    : field_(field), sensors_(sensors), robot_sample_(robot_sample) {
  constexpr double least = 0.5;  // counts
  for (std::size_t i = 0; i < sensors.infrared.size(); ++i) {
    const Infrared& sensor = sensors.infrared[i];
    const InfraredCurve curve(sensor, field.cell());
    const double factor = robot_sample.infrared[i];
    emitters_.push_back({direction_of(sensor.beam.angle), curve, factor,
                         curve.distance(std::min(least / factor, curve.level(0.0))), 1.0 / sensor.footprint});
  }
  for (const Ranger& ranger : sensors.rangers) rangers_.push_back(direction_of(ranger.beam.angle));
}

/// Calls visit(crossing) for the lines that a ray meets, the nearest first, until it returns false or the maze ends.
template <class Visit>
void Beams::for_each_crossing(const Ray& ray, Visit visit) const {
  const double cell = field_.cell();
  const auto& [sine, cosine] = ray.direction;
  Lines x = lines_of(field_, ray.from.x, cosine), y = lines_of(field_, ray.from.y, sine);
  const Heading side_x = x.step > 0 ? Heading::east : Heading::west;
  const Heading side_y = y.step > 0 ? Heading::north : Heading::south;
  for (;;) {
    const bool upright = x.next < y.next;
    Lines& met = upright ? x : y;
    const double along = upright ? ray.from.y + met.next * sine : ray.from.x + met.next * cosine;
    const int other = field_.index_at(along);
    Crossing crossing = {met.next,
                         met.cosine,
                         upright ? met.cell : other,
                         upright ? other : met.cell,
                         upright ? side_x : side_y,
                         along - other * cell};
    if (!field_.contains(crossing.column, crossing.row)) return;
    if (field_.most_shift() > 0.0) displace(crossing, upright, met.step);
    if (!visit(crossing)) return;
    met.cell += met.step;
    met.next += met.between;
  }
}

/// Moves a crossing to where the wall and its posts are; `upright`: the line is across x; `step`: 1 if it is crossed
/// towards higher coordinates, or -1.
void Beams::displace(Crossing& crossing, bool upright, int step) const {
  // Towards a wall that the ray hardly meets, the distance changes by more than the shift, but by no more than this.
  constexpr double least_cosine = 0.2;
  const int line = (upright ? crossing.column : crossing.row) + (step > 0 ? 1 : 0);
  const int first = upright ? crossing.row : crossing.column;
  const double place = first * field_.cell() + crossing.along;
  const Position low = upright ? field_.post_shift(line, first) : field_.post_shift(first, line);
  const Position high = upright ? field_.post_shift(line, first + 1) : field_.post_shift(first + 1, line);
  const double shift = upright ? field_.upright_shift(line, place) : field_.level_shift(place, line);
  crossing.distance = std::max(0.0, crossing.distance + step * shift / std::max(least_cosine, crossing.cosine));
  crossing.low = upright ? low.y : low.x;
  crossing.high = upright ? high.y : high.x;
}

/// The share of a beam's spot that lies on walls and posts.
///
///      below       along                       above
///      ---o=========o---          posts o, the side's wall =, its neighbours -
///         0        cell
double Beams::share_of(const Crossing& crossing, double per_footprint) const {
  const double half = field_.half_wall(), along = crossing.along;
  const double first = crossing.low, last = field_.cell() + crossing.high;
  const double per_deviation = crossing.cosine * per_footprint;
  const int column = crossing.column, row = crossing.row;
  const Heading side = crossing.side;
  const bool stands = field_.stands(column, row, side);
  const bool low = (along - first - half) * per_deviation < NormalShare::reach;
  const bool high = (last - half - along) * per_deviation < NormalShare::reach;
  if (!low && !high) return stands ? 1.0 : 0.0;
  const bool upright = side == Heading::east || side == Heading::west;
  const int x = upright ? 0 : 1, y = upright ? 1 : 0;
  const auto below = [&](double point) { return NormalShare::below((point - along) * per_deviation); };
  double share = stands ? 1.0 : 0.0;
  if (low) {
    const bool more = field_.stands(column - x, row - y, side);
    // The post reaches to both sides of its middle; beyond it is the neighbouring wall, if it stands.
    share += (stands ? 0.0 : below(first + half)) - (more ? 0.0 : below(first - half));
  }
  if (high) {
    const bool more = field_.stands(column + x, row + y, side);
    share += (stands ? 0.0 : 1.0 - below(last - half)) - (more ? 0.0 : 1.0 - below(last + half));
  }
  return std::clamp(share, 0.0, 1.0);
}

double Beams::level(std::size_t sensor, const Position& position, const Direction& ahead) const {
  const Emitter& emitter = emitters_[sensor];
  double level = 0.0, passing = 1.0;
  for_each_crossing(ray_of(sensors_.infrared[sensor].beam, emitter.direction, position, ahead),
                    [&](const Crossing& crossing) {
                      if (crossing.distance > emitter.reach) return false;
                      const double share = share_of(crossing, emitter.per_footprint);
                      if (share > 0.0) {
                        level += passing * share * emitter.factor * emitter.curve.level(crossing.distance) *
                                 returned_at(crossing.cosine) *
                                 robot_sample_.reflectance({crossing.column, crossing.row}, crossing.side);
                        passing *= 1.0 - share;
                      }
                      return passing > 0.02;
                    });
  return std::min(level, sensors_.infrared[sensor].most);
}

double Beams::range(std::size_t sensor, const Position& position, const Direction& ahead) const {
  const Ranger& ranger = sensors_.rangers[sensor];
  const Ray ray = ray_of(ranger.beam, rangers_[sensor], position, ahead);
  const double cell = field_.cell(), half = field_.half_wall();
  double range = 0.0;
  for_each_crossing(ray, [&](const Crossing& crossing) {
    if (crossing.distance > ranger.reach) return false;
    const bool post = crossing.along < crossing.low + half || crossing.along > cell + crossing.high - half;
    if (!post && !field_.stands(crossing.column, crossing.row, crossing.side)) return true;
    range = std::max(0.0, crossing.distance);
    return false;
  });
  return range;
}

}  // namespace labmouse
