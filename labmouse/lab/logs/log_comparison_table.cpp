// A log beside a robot, as a table.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "labmouse/functions/angles.hpp"
#include "labmouse/hardware/sense.hpp"
#include "labmouse/lab/logs/log_comparison.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

constexpr double degrees = 180.0 / pi;

struct CurveLine {
  std::string_view name, unit;
  const ComparedCurve& curve;
  double factor;
};

std::string seconds_of(std::size_t tick) { return fmt::format("{:.3f}", static_cast<double>(tick) * tick_seconds); }

std::string text_of(const CurveLine& line) {
  const auto& [log, robot, parts] = line.curve;
  if (log.empty()) return "";
  double squares = 0.0, most = 0.0, peak = 0.0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double off = line.factor * (robot[i] - log[i]);
    squares += off * off;
    most = std::max(most, std::abs(off));
    peak = std::max(peak, line.factor * std::abs(log[i]));
  }
  const double rms = std::sqrt(squares / static_cast<double>(log.size()));
  return fmt::format("{:<12} {:>9.4g} {:>9.3g} {:>8.1f} {:>9.3g} {:>10.3g} {:>10}\n",
                     fmt::format("{} {}", line.name, line.unit), peak, rms, peak > 0.0 ? 100.0 * rms / peak : 0.0, most,
                     line.factor * (robot.back() - log.back()), parts ? seconds_of(*parts) : "-");
}

/// Where the first of the curves parts.
std::string parting_of(const LogComparison& comparison, std::span<const CurveLine> lines) {
  const CurveLine* first = nullptr;
  for (const CurveLine& line : lines)
    if (line.curve.parts && (first == nullptr || *line.curve.parts < *first->curve.parts)) first = &line;
  if (first == nullptr)
    return fmt::format("they do not part: nothing differs by {:g} % of its peak\n", 100.0 * parting_share);
  const std::size_t tick = *first->curve.parts;
  std::string where;
  if (!comparison.way.log.empty()) where += fmt::format(", {} mm on its way", std::lround(comparison.way.log[tick]));
  if (!comparison.turn.log.empty())
    where += fmt::format(", turned {} degrees", std::lround(degrees * comparison.turn.log[tick]));
  return fmt::format("they part at {} s, first in {}: the log's mouse was then{}\n", seconds_of(tick), first->name,
                     where.substr(1));
}

}  // namespace

std::string table_of(const LogComparison& comparison, std::string_view log_name, std::string_view robot_name) {
  const std::array<CurveLine, 4> lines = {{{"speed", "mm/s", comparison.speed, 1.0},
                                           {"yaw", "rad/s", comparison.yaw, 1.0},
                                           {"way", "mm", comparison.way, 1.0},
                                           {"turn", "degrees", comparison.turn, degrees}}};
  const std::size_t ticks = std::max(comparison.way.log.size(), comparison.turn.log.size());
  std::string text = fmt::format("{} beside {}, which {}; {:.4g} s\n", shown(log_name), shown(robot_name),
                                 comparison.by_duties ? "got the same duties" : "was driven after the same speeds",
                                 static_cast<double>(ticks) * tick_seconds);
  if (comparison.stronger != 0.0)
    text += fmt::format("its right motor was made {:.1f} % {} than the left one, as the log's is\n",
                        100.0 * std::abs(comparison.stronger), comparison.stronger > 0.0 ? "stronger" : "weaker");
  text += fmt::format("{:<12} {:>9} {:>9} {:>8} {:>9} {:>10} {:>10}\n", "", "peak", "rms off", "% of it", "most off",
                      "at the end", "parts at s");
  for (const CurveLine& line : lines) text += text_of(line);
  return text + parting_of(comparison, lines);
}

}  // namespace labmouse
