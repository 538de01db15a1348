#include "labmouse/controller/view.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/exponential.hpp"
#include "labmouse/functions/position.hpp"
#include "labmouse/hardware/beam.hpp"

namespace labmouse {

Position way_in(Heading heading) { return way_of_eighths(2 * static_cast<int>(heading)); }

WallLine line_on(Cell cell, Heading side, Heading axis, double size) {
  const Position out = way_in(side);
  const Position middle = {(cell.x + 0.5) * size, (cell.y + 0.5) * size};
  return {out, way_in(axis), dot(middle, out) + size / 2.0 - half_wall_of(size)};
}

Views::Views(const Infrared& infrared, double cell) : infrared_(infrared) {
  for (std::size_t beam = 0; beam < beam_count; ++beam) {
    directions_[beam] = direction_of(infrared.beams[beam].angle);
    gains_[beam] = infrared.gain * exp_of(calibrated_distance(infrared.beams[beam], cell) / infrared.fall);
    aside_[beam] = labmouse::looks_aside(infrared.beams[beam]);
  }
}

/// From the middle of the axle to a sensor.
Position arm_of(const Beam& beam, const Direction& ahead) {
  return {beam.ahead * ahead.cosine - beam.aside * ahead.sine, beam.ahead * ahead.sine + beam.aside * ahead.cosine};
}

Position Views::way_of(std::size_t beam, const Direction& ahead) const {
  const Direction& own = directions_[beam];
  return {ahead.cosine * own.cosine - ahead.sine * own.sine, ahead.sine * own.cosine + ahead.cosine * own.sine};
}

bool Views::see(std::size_t beam, const Position& position, const Direction& ahead, const WallLine& line,
                View& view) const {
  constexpr double least = 0.2;
  const Position way = way_of(beam, ahead);
  view.cosine = dot(way, line.out);
  if (view.cosine < least) return false;
  const Position from = position + arm_of(infrared_.beams[beam], ahead);
  view.distance = (line.face - dot(from, line.out)) / view.cosine;
  view.along = dot(from, line.on) + view.distance * dot(way, line.on);
  return view.distance >= 0.0;
}

ViewSlopes Views::slopes(std::size_t beam, const Direction& ahead, const WallLine& line, const View& view) const {
  const auto& [out, on, face] = line;
  // Derivative of the point that the beam meets by the mouse's angle, at a fixed length of the beam.
  const Position arm = arm_of(infrared_.beams[beam], ahead), way = way_of(beam, ahead);
  const Position turned = {-arm.y - view.distance * way.y, arm.x + view.distance * way.x};
  const double beside = dot(way, on);
  ViewSlopes slopes;
  slopes.distance = {-out.x / view.cosine, -out.y / view.cosine, -dot(turned, out) / view.cosine};
  slopes.along = {on.x + slopes.distance[0] * beside, on.y + slopes.distance[1] * beside,
                  dot(turned, on) + slopes.distance[2] * beside};
  // A more oblique wall reflects less, so it reads as farther away.
  if (returned_at(view.cosine) < 1.0) slopes.distance[2] += infrared_.fall / view.cosine * dot({way.y, -way.x}, out);
  return slopes;
}

double Views::level_of(std::size_t beam, const View& view) const {
  return std::min(infrared_.most, gains_[beam] * returned_at(view.cosine) * fading(view.distance / infrared_.fall));
}

double Views::distance_of(std::size_t beam, double level, const View& view) const {
  return infrared_.fall * log_of(gains_[beam] * returned_at(view.cosine) / level);
}

}  // namespace labmouse
