#include "labmouse/lab/drives/drive_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/functions/angles.hpp"
#include "labmouse/hardware/beam.hpp"

namespace labmouse {
namespace {

/// The name of a column, or with the number of the sensor if another one has it.
void add_column(std::string name, std::string_view kind, std::size_t number, std::vector<std::string>& columns) {
  if (std::find(columns.begin(), columns.end(), name) != columns.end()) name = fmt::format("{}_{}", kind, number);
  columns.push_back(std::move(name));
}

std::string infrared_column(const Beam& beam) {
  const BeamSide side = side_of(beam);
  if (side != BeamSide::ahead) return side == BeamSide::left ? "ir_left" : "ir_right";
  return beam.aside == 0.0 ? "ir_ahead" : beam.aside > 0.0 ? "ir_left_ahead" : "ir_right_ahead";
}

std::string range_column(const Beam& beam) {
  const BeamSide side = side_of(beam);
  return side == BeamSide::ahead ? "range" : side == BeamSide::left ? "range_left" : "range_right";
}

std::string heading_line(const Sensors& sensors) {
  std::vector<std::string> columns = {"time",        "left", "right",        "left_count",
                                      "right_count", "gyro", "acceleration", "acceleration_left"};
  for (std::size_t i = 0; i < sensors.infrared.size(); ++i)
    add_column(infrared_column(sensors.infrared[i].beam), "ir", i, columns);
  for (std::size_t i = 0; i < sensors.rangers.size(); ++i)
    add_column(range_column(sensors.rangers[i].beam), "range", i, columns);
  std::string names;
  for (const std::string& column : columns) names += column + ",";
  return fmt::format("{}millivolts,true_way,true_wall_right,true_wall_left,true_wall_ahead,true_x,true_y,true_angle\n",
                     names);
}

/// Whether the robot points along or across walls, within 1 degree.
bool is_in_line(const Direction& ahead) {
  constexpr double sine_of_degree = 0.017452406437283513;
  return std::min(std::abs(ahead.sine), std::abs(ahead.cosine)) < sine_of_degree;
}

/// Length of a beam to the first side of the cell that it meets; nullopt where that side has no wall, or where the
/// beam's spot reaches beyond the wall's end posts.
std::optional<double> way_to_wall(const Field& field, const Infrared& infrared, const BodyMotion& motion) {
  const Beam& beam = infrared.beam;
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
std::optional<double> wall_of(const Field& field, const Infrared& infrared, const BodyMotion& motion) {
  const Beam& beam = infrared.beam;
  if (!is_in_line(motion.ahead)) return std::nullopt;
  const std::optional<double> way = way_to_wall(field, infrared, motion);
  if (!way) return std::nullopt;
  const Direction own = direction_of(beam.angle);
  const bool aside = side_of(beam) != BeamSide::ahead;
  return aside ? out_of(beam) + *way * std::abs(own.sine) : beam.ahead + *way * own.cosine;
}

/// The mean of that over the sensors which look there; nullopt unless each meets a wall.
std::optional<double> wall_at(BeamSide side, const Field& field, const Sensors& sensors, const BodyMotion& motion) {
  double sum = 0.0;
  int count = 0;
  for (const Infrared& sensor : sensors.infrared) {
    if (side_of(sensor.beam) != side) continue;
    const auto way = wall_of(field, sensor, motion);
    if (!way) return std::nullopt;
    sum += *way;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::string field_of(const std::optional<double>& length) { return length ? fmt::format("{:.3f}", *length) : ""; }

}  // namespace

std::string log_text(std::span<const LoggedTick> ticks, const Field& field, const Hardware& hardware) {
  const Sensors& sensors = hardware.sensors;
  std::string text = heading_line(sensors);
  double way = 0.0;
  for (const LoggedTick& tick : ticks) {
    const Sense& sense = tick.sense;
    const BodyMotion& motion = tick.motion;
    if (&tick != ticks.data()) way += motion.speed * tick_seconds;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "{},{:.6g},{:.6g},{},{},{},{},{}", sense.tick - ticks.front().sense.tick, tick.drive.left,
                   tick.drive.right, sense.counts[0], sense.counts[1], sense.gyro, sense.acceleration[0],
                   sense.acceleration[1]);
    for (const std::int16_t level : sense.all_infrared()) fmt::format_to(out, ",{}", level);
    for (const RangeSense& range : sense.all_ranges()) fmt::format_to(out, ",{}", range.distance);
    const auto wall = [&](BeamSide side) { return field_of(wall_at(side, field, sensors, motion)); };
    fmt::format_to(out, ",{},{:.3f},{},{},{},{:.3f},{:.3f},{:.5f}\n", sense.millivolts, way, wall(BeamSide::right),
                   wall(BeamSide::left), wall(BeamSide::ahead), motion.position.x, motion.position.y, motion.angle);
  }
  return text;
}

}  // namespace labmouse
