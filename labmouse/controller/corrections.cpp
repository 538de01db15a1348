#include "labmouse/controller/corrections.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/whole.hpp"
#include "labmouse/hardware/beam.hpp"

namespace labmouse {
namespace {

/// A sensor corrects at every eighth call. Its errors (reflectance of the wall, gain) are the same along a wall, so
/// more readings add no information.
constexpr unsigned calls_between = 8;
/// Factor on the variance: the gain error is the same at the next walls, too.
constexpr double alike = 1.5;
/// Lower bound of the speed, mm/s.
constexpr double slow = 50.0;

WallState state_of(const Knowledge* known, Cell cell, Heading side, Size size) {
  const Wall wall = wall_at(cell, side);
  if (on_border(wall, size)) return WallState::closed;
  return known == nullptr ? WallState::unknown : known->state(wall);
}

}  // namespace

std::optional<Corridor> corridor_of(const Target& target, double cell) {
  constexpr double straight = 0.978;  // the cosine of 12 degrees
  const double c = target.ahead.cosine, s = target.ahead.sine;
  if (std::max(std::abs(c), std::abs(s)) < straight) return std::nullopt;
  const Heading axis = std::abs(c) > std::abs(s) ? (c > 0.0 ? Heading::east : Heading::west)
                                                 : (s > 0.0 ? Heading::north : Heading::south);
  return Corridor{{whole_below(target.position.x / cell), whole_below(target.position.y / cell)}, axis};
}

Corrections::Corrections(const Hardware& hardware, double cell, Size size, const CorrectionChoice& choice)
    : hardware_(hardware),
      cell_(cell),
      size_(size),
      choice_(choice),
      views_(hardware.sensors.infrared, cell),
      finders_(hardware.sensors.infrared.size(), EdgeFinder(cell / 5.0, half_wall_of(cell))) {
  for (const Ranger& ranger : hardware.sensors.rangers) mounts_.push_back(mount_of(ranger));
}

void Corrections::forget() {
  for (EdgeFinder& finder : finders_) finder.forget();
}

Cell Corrections::cell_along(const Corridor& corridor, double along) const {
  const int number = whole_below(along / cell_);
  switch (corridor.axis) {
    case Heading::north:
      return {corridor.cell.x, number};
    case Heading::east:
      return {number, corridor.cell.y};
    case Heading::south:
      return {corridor.cell.x, -number - 1};
    case Heading::west:
      break;
  }
  return {-number - 1, corridor.cell.y};
}

void Corrections::apply(const Sense& sense, const Target& target, const Knowledge* known, Estimator& estimator) {
  const auto corridor = corridor_of(target, cell_);
  if (!corridor) {
    forget();
    return;
  }
  for (std::size_t i = 0; i < finders_.size(); ++i)
    if (views_.side(i) != BeamSide::ahead) see_side(i, sense, *corridor, known, estimator);
  for (std::size_t i = 0; i < mounts_.size(); ++i) {
    const bool wanted = mounts_[i].side == BeamSide::ahead ? choice_.front : choice_.sides;
    if (const RangeSense& seen = sense.ranges[i]; wanted && seen.is_new && seen.distance > 0)
      see_range(mounts_[i], seen.distance, *corridor, known, estimator);
  }
}

void Corrections::see_side(std::size_t sensor, const Sense& sense, const Corridor& corridor, const Knowledge* known,
                           Estimator& estimator) {
  const Heading side = side_in(corridor.axis, views_.side(sensor));
  const WallLine wall_line = line_on(corridor.cell, side, corridor.axis, cell_);
  View view;
  if (!views_.see(sensor, estimator.position(), estimator.ahead(), wall_line, view)) {
    finders_[sensor].forget();
    return;
  }
  const auto slopes = [&] { return views_.slopes(sensor, estimator.ahead(), wall_line, view); };
  const double level = std::max<double>(1.0, sense.infrared[sensor]);
  const int line = whole_below(view.along / cell_ + 0.5);
  const double behind = view.along - line * cell_;
  const Cell cell = cell_along(corridor, view.along);
  if (choice_.edges && finders_[sensor].needs(behind)) {
    const double share = std::min(1.5, level / views_.level_of(sensor, view));
    if (const auto edge = finders_[sensor].pass(line, behind, share))
      see_edge(*edge, view, slopes(), cell_along(corridor, (line + 0.5) * cell_), side, corridor.axis, known,
               estimator);
  }
  const auto turn = sense.tick / static_cast<unsigned>(hardware_.motors.period) + sensor;
  // Away from posts.
  if (choice_.sides && turn % calls_between == 0 && std::abs(behind) > cell_ / 4.0 && size_.contains(cell) &&
      state_of(known, cell, side, size_) != WallState::open)
    see_wall(sensor, level, view, slopes(), estimator);
}

void Corrections::see_wall(std::size_t sensor, double level, const View& view, const ViewSlopes& slopes,
                           Estimator& estimator) const {
  const Infrared& infrared = hardware_.sensors.infrared[sensor];
  constexpr double least = 0.12, most = 0.95;
  if (level < least * infrared.gain || level > most * infrared.most) return;
  const Noise& noise = hardware_.noise;
  // The errors of the readings of one wall are correlated, so their variance is multiplied by the number of readings.
  const double between =
      std::max(slow, std::abs(estimator.speed())) * calls_between * hardware_.motors.period * tick_seconds;
  const double many = std::max(1.0, alike * cell_ / 2.0 / between);
  const double share = (reading_variance(hardware_.variation, level) + square(noise.infrared)) / square(level);
  // So have those of the other sensors that look there.
  const int sensors = views_.count_of(views_.side(sensor));
  estimator.correct({views_.distance_of(sensor, level, view) - view.distance, slopes.distance[0], slopes.distance[1],
                     slopes.distance[2], sensors * many * square(views_.fall_of(sensor, view)) * share + 0.25});
}

/// `behind` is the cell of the corridor behind the line.
void Corrections::see_edge(const SeenEdge& seen, const View& view, const ViewSlopes& slopes, Cell behind, Heading side,
                           Heading axis, const Knowledge* known, Estimator& estimator) const {
  const Cell before = neighbour(behind, axis, -1);
  const auto fits = [&](Cell cell, bool stands) {
    if (!size_.contains(cell)) return false;
    const WallState state = state_of(known, cell, side, size_);
    return state == WallState::unknown || (state == WallState::closed) == stands;
  };
  if (!fits(before, seen.edge == Edge::falls) || !fits(behind, seen.edge == Edge::rises)) return;
  // The edge is at the line, but an oblique beam also sees the side of a post. So a wall seems to begin before the
  // post, and to continue behind it. The factors come from numerical integration of the light that such beams reflect.
  const double post_side = 2.0 * half_wall_of(cell_) * std::sqrt(std::max(0.0, 1.0 / square(view.cosine) - 1.0));
  const double seeming = seen.edge == Edge::rises   ? -0.38 * post_side
                         : seen.edge == Edge::falls ? 0.2 * post_side
                                                    : 0.0;
  constexpr double deviation = 0.02;  // of a cell
  estimator.correct(
      {seeming - seen.behind, slopes.along[0], slopes.along[1], slopes.along[2], square(deviation * cell_)});
}

void Corrections::see_range(const RangerMount& mount, double distance, const Corridor& corridor, const Knowledge* known,
                            Estimator& estimator) const {
  const Heading side = side_in(corridor.axis, mount.side);
  const Position on = way_in(side);
  const double in_line = dot({estimator.ahead().cosine, estimator.ahead().sine}, way_in(corridor.axis));
  const double way = distance * mount.cosine, from = dot(estimator.position(), on);
  const double face = from + (mount.depth + way) * in_line;
  const int line = whole_below((face + half_wall_of(cell_)) / cell_ + 0.5);
  const double error = line * cell_ - half_wall_of(cell_) - face;
  const bool ahead = mount.side == BeamSide::ahead;
  const double along = dot(estimator.position(), way_in(corridor.axis)) + mount.along + distance * mount.along_cosine;
  const Cell before = cell_along(corridor, ahead ? (line - 0.5) * cell_ : along);
  // Beside it, only the wall of the corridor counts.
  if (!ahead && std::abs(line * cell_ - cell_ / 2.0 -
                         dot({(corridor.cell.x + 0.5) * cell_, (corridor.cell.y + 0.5) * cell_}, on)) > 0.5 * cell_)
    return;
  // The more uncertain the position, the larger the accepted error, up to where the wall could be another one.
  const double uncertainty = 2.5 * std::sqrt(estimator.variance_of(on.x, on.y, 0.0));
  const double most = std::clamp(uncertainty, 0.2 * cell_, 0.42 * cell_);
  if (distance > 2.0 * cell_ || std::abs(error) > most || !size_.contains(before)) return;
  if (state_of(known, before, side, size_) == WallState::open) return;
  const Noise& noise = hardware_.noise;
  // Measured less expected: if the wall is farther than expected, the mouse is less far along.
  estimator.correct({-error, -on.x, -on.y, 0.0, square(2.0 * noise.ranger) + square(0.01 * cell_)});
}

}  // namespace labmouse
