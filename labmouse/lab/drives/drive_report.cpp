#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/lab/drives/known_drives.hpp"
#include "labmouse/lab/numbers/wilson.hpp"
#include "labmouse/lab/text/errors_text.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

double deviation(double squares, std::int64_t ticks) {
  return ticks == 0 ? 0.0 : std::sqrt(squares / static_cast<double>(ticks));
}

/// Quantile of sorted numbers; 0 if there are none.
double quantile(const std::vector<double>& numbers, double share) {
  if (numbers.empty()) return 0.0;
  const auto index = static_cast<std::size_t>(share * static_cast<double>(numbers.size()));
  return numbers[std::min(index, numbers.size() - 1)];
}

constexpr double degrees = 180.0 / 3.14159265358979323846;

Json errors_json(const WayErrors& errors, std::int64_t ticks) {
  return {{"longitudinal_mm", deviation(errors.along, ticks)},
          {"lateral_mm", deviation(errors.aside, ticks)},
          {"heading_degrees", degrees * deviation(errors.direction, ticks)}};
}

Json readings_json(const WallReadings& readings) {
  return {{"all", readings.all}, {"wrong", readings.wrong}, {"share", share_of(readings.wrong, readings.all)}};
}

}  // namespace

std::string table_of(std::span<const DriveTally> tallies, const DriveOrder& order) {
  std::size_t width = 14;
  for (const DriveTally& tally : tallies) width = std::max(width, shown(tally.name).size());
  std::string text = fmt::format("Robot {}; {}\n\n", shown(order.model->robot.name), scales_text());
  text += fmt::format("{:<{}} {:>6} {:>8} {:>13} {:>7} {:>7} {:>8} {:>8} {:>8} {:>12} {:>9} {:>9} {:>8}\n", "", width,
                      "", "crashed", "95 %", "without", "worst", "lateral", "longit.", "heading", "max. lateral",
                      "side", "front", "cells a");
  text += fmt::format("{:<{}} {:>6} {:>8} {:>13} {:>7} {:>7} {:>8} {:>8} {:>8} {:>12} {:>9} {:>9} {:>8}\n", "", width,
                      "runs", "%", "interval", "any %", "maze %", "mm", "mm", "deg.", "50, 95 % mm", "wrong %",
                      "wrong %", "crash");
  for (const DriveTally& tally : tallies) {
    const Interval& interval = tally.interval;
    text += fmt::format(
        "{:<{}} {:>6} {:>8.2f} {:>13} {:>7.0f} {:>7.0f} {:>8.2f} {:>8.2f} {:>8.2f} {:>12} {:>9.4f} {:>9.4f} {:>8}\n",
        shown(tally.name), width, tally.runs, 100.0 * share_of(tally.crashed, tally.runs),
        fmt::format("{:.2f}-{:.2f}", 100.0 * interval.low, 100.0 * interval.high),
        100.0 * share_of(tally.mazes_without_crash, tally.mazes), 100.0 * tally.worst_share,
        deviation(tally.truth.aside, tally.ticks), deviation(tally.truth.along, tally.ticks),
        degrees * deviation(tally.truth.direction, tally.ticks),
        fmt::format("{:.1f}, {:.1f}", quantile(tally.most_aside, 0.5), quantile(tally.most_aside, 0.95)),
        100.0 * share_of(tally.side.wrong, tally.side.all), 100.0 * share_of(tally.front.wrong, tally.front.all),
        tally.crashed == 0 || tally.cells == 0 ? "-" : fmt::format("{}", tally.cells / tally.crashed));
  }
  if (is_stopped(tallies)) text += "\nStopped early: not all drives are done.\n";
  return text;
}

std::string json_of(std::span<const DriveTally> tallies, const DriveOrder& order) {
  Json list = Json::array();
  for (const DriveTally& tally : tallies) {
    const Interval& interval = tally.interval;
    list.push_back({{"name", tally.name},
                    {"stopped", tally.stopped},
                    {"mazes", tally.mazes},
                    {"mazes_without_crash", tally.mazes_without_crash},
                    {"worst_maze", tally.worst_maze},
                    {"worst_share", tally.worst_share},
                    {"runs", tally.runs},
                    {"crashed", tally.crashed},
                    {"interval", {interval.low, interval.high}},
                    {"cells", tally.cells},
                    {"seconds", static_cast<double>(tally.ticks) * tick_seconds},
                    {"grazes", tally.grazes},
                    {"truth", errors_json(tally.truth, tally.ticks)},
                    {"estimate", errors_json(tally.estimate, tally.ticks)},
                    {"largest_lateral_mm", {quantile(tally.most_aside, 0.5), quantile(tally.most_aside, 0.95)}},
                    {"side_readings", readings_json(tally.side)},
                    {"front_readings", readings_json(tally.front)}});
  }
  const Json json = {{"robot", order.model->robot.name},
                     {"way", order.way == KnownWay::search ? "search" : "fast"},
                     {"runs", order.runs},
                     {"seed", order.seed},
                     {"stopped", is_stopped(tallies)},
                     {"drives", std::move(list)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace labmouse
