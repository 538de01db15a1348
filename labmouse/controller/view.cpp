#include "labmouse/controller/view.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/position.hpp"
#include "labmouse/hardware/beam.hpp"

namespace labmouse {

Position way_in(Heading heading) { return way_of_eighths(eighths(heading)); }

WallLine line_on(Cell cell, Heading side, Heading axis, double size) {
  const Position out = way_in(side);
  const Position middle = {(cell.x + 0.5) * size, (cell.y + 0.5) * size};
  return {out, way_in(axis), dot(middle, out) + size / 2.0 - half_wall_of(size)};
}

Heading side_in(Heading heading, BeamSide side) {
  return side == BeamSide::ahead ? heading : side == BeamSide::left ? left_of(heading) : right_of(heading);
}

Views::Views(const std::vector<Infrared>& sensors, double cell) {
  for (const Infrared& sensor : sensors)
    sensors_.push_back(
        {sensor.beam, direction_of(sensor.beam.angle), side_of(sensor.beam), InfraredCurve(sensor, cell), sensor.most});
}

/// From the middle of the axle to a sensor.
Position arm_of(const Beam& beam, const Direction& ahead) {
  return {beam.ahead * ahead.cosine - beam.aside * ahead.sine, beam.ahead * ahead.sine + beam.aside * ahead.cosine};
}

Position Views::way_of(std::size_t sensor, const Direction& ahead) const {
  const Direction& own = sensors_[sensor].direction;
  return {ahead.cosine * own.cosine - ahead.sine * own.sine, ahead.sine * own.cosine + ahead.cosine * own.sine};
}

double Views::cosine_in_line(std::size_t sensor) const {
  const auto& [sine, cosine] = sensors_[sensor].direction;
  return sensors_[sensor].side == BeamSide::ahead ? cosine : std::abs(sine);
}

int Views::count_of(BeamSide side) const {
  return static_cast<int>(
      std::count_if(sensors_.begin(), sensors_.end(), [&](const Mounted& one) { return one.side == side; }));
}

double Views::share_of(std::size_t sensor) const { return std::min(1.0, 2.0 / count_of(sensors_[sensor].side)); }

bool Views::see(std::size_t sensor, const Position& position, const Direction& ahead, const WallLine& line,
                View& view) const {
  constexpr double least = 0.2;
  const Position way = way_of(sensor, ahead);
  view.cosine = dot(way, line.out);
  if (view.cosine < least) return false;
  const Position from = position + arm_of(sensors_[sensor].beam, ahead);
  view.distance = (line.face - dot(from, line.out)) / view.cosine;
  view.along = dot(from, line.on) + view.distance * dot(way, line.on);
  return view.distance >= 0.0;
}

ViewSlopes Views::slopes(std::size_t sensor, const Direction& ahead, const WallLine& line, const View& view) const {
  const auto& [out, on, face] = line;
  // Derivative of the point that the beam meets by the mouse's angle, at a fixed length of the beam.
  const Position arm = arm_of(sensors_[sensor].beam, ahead), way = way_of(sensor, ahead);
  const Position turned = {-arm.y - view.distance * way.y, arm.x + view.distance * way.x};
  const double beside = dot(way, on);
  ViewSlopes slopes;
  slopes.distance = {-out.x / view.cosine, -out.y / view.cosine, -dot(turned, out) / view.cosine};
  slopes.along = {on.x + slopes.distance[0] * beside, on.y + slopes.distance[1] * beside,
                  dot(turned, on) + slopes.distance[2] * beside};
  // A more oblique wall reflects less, so it reads as farther away.
  if (returned_at(view.cosine) < 1.0)
    slopes.distance[2] += fall_of(sensor, view) / view.cosine * dot({way.y, -way.x}, out);
  return slopes;
}

double Views::level_of(std::size_t sensor, const View& view) const {
  const Mounted& mounted = sensors_[sensor];
  return std::min(mounted.most, mounted.curve.level(view.distance, returned_at(view.cosine)));
}

double Views::distance_of(std::size_t sensor, double level, const View& view) const {
  return sensors_[sensor].curve.distance(level, returned_at(view.cosine));
}

}  // namespace labmouse
