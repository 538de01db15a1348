#include "labmouse/pilot/view.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/exponential.hpp"
#include "labmouse/hardware/beam.hpp"

namespace labmouse {

Position way_in(Heading heading) {
  constexpr std::array<Position, 4> ways = {{{0.0, 1.0}, {1.0, 0.0}, {0.0, -1.0}, {-1.0, 0.0}}};
  return ways[static_cast<unsigned>(heading)];
}

double line_at(Cell cell, Heading side, double size) {
  switch (side) {
    case Heading::north:
      return (cell.y + 1) * size;
    case Heading::east:
      return (cell.x + 1) * size;
    case Heading::south:
      return cell.y * size;
    case Heading::west:
      break;
  }
  return cell.x * size;
}

Views::Views(const Infrared& infrared, double cell) : infrared_(infrared), cell_(cell) {
  for (std::size_t beam = 0; beam < beam_count; ++beam) {
    directions_[beam] = direction_of(infrared.beams[beam].angle);
    calibrated_[beam] = calibrated_distance(infrared.beams[beam], cell);
    aside_[beam] = labmouse::looks_aside(infrared.beams[beam]);
  }
}

bool Views::see(std::size_t beam, const Position& position, const Direction& ahead, Cell cell, Heading side,
                Heading axis, View& view) const {
  const Beam& at = infrared_.beams[beam];
  const Direction& own = directions_[beam];
  const Position out = way_in(side), on = way_in(axis);
  const Position arm = {at.ahead * ahead.cosine - at.aside * ahead.sine,
                        at.ahead * ahead.sine + at.aside * ahead.cosine};
  const Position arm_turned = {-arm.y, arm.x};
  const Position beam_way = {ahead.cosine * own.cosine - ahead.sine * own.sine,
                             ahead.sine * own.cosine + ahead.cosine * own.sine};
  const Position way_turned = {-beam_way.y, beam_way.x};
  const double towards = dot(beam_way, out);
  constexpr double least = 0.2;
  if (towards < least) return false;
  // The face lies before the line, as seen along `out`.
  const double coordinate = line_at(cell, side, cell_) * (out.x + out.y) - half_wall_of(cell_);
  const Position from = position + arm;
  view.distance = (coordinate - dot(from, out)) / towards;
  if (view.distance < 0.0) return false;
  view.cosine = towards;
  view.distance_by = {-out.x / towards, -out.y / towards,
                      -(dot(arm_turned, out) + view.distance * dot(way_turned, out)) / towards};
  const double beside = dot(beam_way, on);
  view.along = dot(from, on) + view.distance * beside;
  view.along_by = {on.x + view.distance_by[0] * beside, on.y + view.distance_by[1] * beside,
                   dot(arm_turned, on) + view.distance_by[2] * beside + view.distance * dot(way_turned, on)};
  return true;
}

double Views::level_at(std::size_t beam, double distance) const {
  return std::min(infrared_.most, infrared_.gain * exp_of((calibrated_[beam] - distance) / infrared_.fall));
}

double Views::distance_of(std::size_t beam, double level) const {
  return calibrated_[beam] - infrared_.fall * log_of(level / infrared_.gain);
}

}  // namespace labmouse
