#include "labmouse/lab/drives/drive_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "labmouse/functions/angles.hpp"

namespace labmouse {
namespace {

constexpr std::string_view names =
    "time,left,right,left_count,right_count,gyro,acceleration,acceleration_left,ir_right,ir_right_ahead,ir_"
    "left,"
    "ir_left_ahead,range,millivolts,true_way,true_wall_right,true_wall_left,true_wall_ahead,true_x,true_y,true_angle\n";

/// Whether the robot points along or across walls, within 1 degree.
bool is_in_line(const Direction& ahead) {
  constexpr double sine_of_degree = 0.017452406437283513;
  return std::min(std::abs(ahead.sine), std::abs(ahead.cosine)) < sine_of_degree;
}

/// Length of a beam to the first side of the cell that it meets; nullopt where that side has no wall, or where the
/// beam's spot reaches beyond the wall's end posts.
std::optional<double> way_to_wall(const Field& field, const Infrared& infrared, const Beam& beam,
                                  const BodyMotion& motion) {
  const Direction& ahead = motion.ahead;
  const Position from = {motion.position.x + beam.ahead * ahead.cosine - beam.aside * ahead.sine,
                         motion.position.y + beam.ahead * ahead.sine + beam.aside * ahead.cosine};
  const Direction own = direction_of(beam.angle);
  const double sine = ahead.sine * own.cosine + ahead.cosine * own.sine;
  const double cosine = ahead.cosine * own.cosine - ahead.sine * own.sine;
  const Cell cell = field.cell_at(from);
  const double low = field.half_wall(), high = field.cell() - low;
  const double x = from.x - cell.x * field.cell(), y = from.y - cell.y * field.cell();
  constexpr double never = 1e9, least = 1e-6;
  const double to_x = std::abs(cosine) < least ? never : ((cosine > 0.0 ? high : low) - x) / cosine;
  const double to_y = std::abs(sine) < least ? never : ((sine > 0.0 ? high : low) - y) / sine;
  const double way = std::min(to_x, to_y);
  const Heading side =
      to_x < to_y ? (cosine > 0.0 ? Heading::east : Heading::west) : (sine > 0.0 ? Heading::north : Heading::south);
  const double along = to_x < to_y ? y + way * sine : x + way * cosine;
  const double spot = 3.0 * infrared.footprint / std::abs(to_x < to_y ? cosine : sine);
  if (way <= 0.0 || along - spot < -low || along + spot > field.cell() + low || !field.stands(cell.x, cell.y, side))
    return std::nullopt;
  return way;
}

/// The distance at a right angle from the axle's middle to the wall, as if the robot were in line with the wall.
std::optional<double> wall_of(const Field& field, const Infrared& infrared, BeamPlace place, const BodyMotion& motion) {
  const Beam& beam = infrared.beams[static_cast<std::size_t>(place)];
  if (!is_in_line(motion.ahead)) return std::nullopt;
  const std::optional<double> way = way_to_wall(field, infrared, beam, motion);
  if (!way) return std::nullopt;
  const Direction own = direction_of(beam.angle);
  const bool aside = place == BeamPlace::right || place == BeamPlace::left;
  return aside ? std::abs(beam.aside) + *way * std::abs(own.sine) : beam.ahead + *way * own.cosine;
}

std::string field_of(const std::optional<double>& length) { return length ? fmt::format("{:.3f}", *length) : ""; }

}  // namespace

std::string log_text(std::span<const LoggedTick> ticks, const Field& field, const Hardware& hardware) {
  std::string text(names);
  const Infrared& infrared = hardware.sensors.infrared;
  double way = 0.0;
  for (const LoggedTick& tick : ticks) {
    const Sense& sense = tick.sense;
    const BodyMotion& motion = tick.motion;
    if (&tick != ticks.data()) way += motion.speed * tick_seconds;
    const auto right_ahead = wall_of(field, infrared, BeamPlace::right_ahead, motion);
    const auto left_ahead = wall_of(field, infrared, BeamPlace::left_ahead, motion);
    std::optional<double> ahead;
    if (right_ahead && left_ahead) ahead = (*right_ahead + *left_ahead) / 2.0;
    fmt::format_to(std::back_inserter(text),
                   "{},{:.6g},{:.6g},{},{},{},{},{},{},{},{},{},{},{},{:.3f},{},{},{},{:.3f},{:.3f},{:.5f}\n",
                   sense.tick - ticks.front().sense.tick, tick.drive.left, tick.drive.right, sense.counts[0],
                   sense.counts[1], sense.gyro, sense.acceleration[0], sense.acceleration[1], sense.infrared[0],
                   sense.infrared[1], sense.infrared[2], sense.infrared[3], sense.range, sense.millivolts, way,
                   field_of(wall_of(field, infrared, BeamPlace::right, motion)),
                   field_of(wall_of(field, infrared, BeamPlace::left, motion)), field_of(ahead), motion.position.x,
                   motion.position.y, motion.angle);
  }
  return text;
}

}  // namespace labmouse
