#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/lab/routes/route_report.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/mouse/robot/drive_profile.hpp"

namespace labmouse {
namespace {

double seconds(DriveTime time) { return time / 1e6; }

/// The place and direction of a node, in cells: "(0,7.5) N" is the middle of the wall north of (0,7), heading north.
std::string place_text(const DriveNode& node) {
  constexpr const char* directions[] = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
  const HalfPoint point = half_point(node);
  return fmt::format("({:g},{:g}) {}", (point.x - 1) / 2.0, (point.y - 1) / 2.0, directions[eighths(node)]);
}

std::string segments_text(const DriveRoute& route, const DriveModel& model) {
  std::string text = fmt::format("{:>3}  {:<6} {:<14} {:<14} {:>7} {:>5} {:>8} {:>8}\n", "", "", "from", "to",
                                 "mm/s in", "out", "ms", "at s");
  for (std::size_t i = 0; i < route.segments.size(); ++i) {
    const DriveSegment& segment = route.segments[i];
    const DriveProfile profile(model, route, i);
    text += fmt::format("{:>3}  {:<6} {:<14} {:<14} {:>7.0f} {:>5.0f} {:>8.1f} {:>8.3f}\n", i + 1,
                        notation_of(segment, model.tables), place_text(segment.from), place_text(segment.to),
                        profile.speed_at(0), profile.speed_at(profile.duration()), (segment.end - segment.begin) / 1e3,
                        seconds(segment.end));
  }
  return text;
}

/// Another route's time, and the share of it that this route saves.
std::string gain_text(const RouteReport& report, DriveTime other) {
  if (other >= no_time) return "no route";
  const auto gain = report.gain_over(other);
  return fmt::format("{:.3f} s{}", seconds(other), gain ? fmt::format(", {:.1f} % gained", 100.0 * *gain) : "");
}

std::string gains_text(const RouteReport& report) {
  return fmt::format("without diagonals: {}\nwith search turns (S90) only: {}\n",
                     gain_text(report, report.without_diagonals), gain_text(report, report.small_turns));
}

/// How much slower the fastest route with the fewest cells is, as a share; nothing where it is unknown.
std::optional<double> loss_of(const RouteReport& report) {
  if (!report.fewest_cells_time || report.route.time == 0) return std::nullopt;
  return static_cast<double>(*report.fewest_cells_time) / report.route.time - 1.0;
}

std::string fewest_text(const RouteReport& report) {
  std::string text = fmt::format("fewest cells: {}, ", report.fewest_cells);
  if (report.cells == report.fewest_cells) return text + "as this route\n";
  const auto loss = loss_of(report);
  text += loss ? fmt::format("at best {:.3f} s, {:.1f} % slower", seconds(*report.fewest_cells_time), 100.0 * *loss)
               : "their best time is unknown";
  return text + fmt::format("; this route enters {}\n", report.cells);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 != 0 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::string percent(const std::optional<double>& share) {
  return number(share ? std::optional(100.0 * *share) : std::nullopt, 1);
}

/// The columns of a line: the fastest route, without diagonals and its gain, with small turns and its gain, cells,
/// fewest cells, and how much slower a route with the fewest cells is.
using SummaryColumns = std::array<std::string, 8>;

std::string summary_line(const SummaryColumns& numbers, const std::string& maze) {
  std::string line;
  for (const std::string& number : numbers) line += fmt::format("{}{:>8}", line.empty() ? "" : " ", number);
  return line + (maze.empty() ? "" : "  ") + maze + "\n";
}

std::optional<double> seconds_if_any(DriveTime time) {
  return time < no_time ? std::optional(seconds(time)) : std::nullopt;
}

std::string line_of(const RouteReport& report, const NamedMaze& maze) {
  if (!report.error.empty())
    return summary_line({"none", "-", "-", "-", "-", "-", "-", "-"}, shown(maze.name) + ": " + report.error);
  return summary_line(
      {number(seconds(report.route.time), 3), number(seconds_if_any(report.without_diagonals), 3),
       percent(report.gain_over(report.without_diagonals)), number(seconds_if_any(report.small_turns), 3),
       percent(report.gain_over(report.small_turns)), fmt::format("{}", report.cells),
       fmt::format("{}", report.fewest_cells), percent(loss_of(report))},
      shown(maze.name));
}

/// The medians over all mazes with a route, and the number of mazes where a longer way is faster.
std::string medians_text(const std::vector<RouteReport>& reports) {
  std::vector<double> times, without, gains, small, small_gains, losses, cells, fewest;
  int longer = 0;
  for (const RouteReport& report : reports) {
    if (!report.error.empty()) continue;
    times.push_back(seconds(report.route.time));
    cells.push_back(report.cells);
    fewest.push_back(report.fewest_cells);
    if (const auto time = seconds_if_any(report.without_diagonals)) without.push_back(*time);
    if (const auto gain = report.gain_over(report.without_diagonals)) gains.push_back(*gain);
    if (const auto time = seconds_if_any(report.small_turns)) small.push_back(*time);
    if (const auto gain = report.gain_over(report.small_turns)) small_gains.push_back(*gain);
    if (report.cells == report.fewest_cells) continue;
    ++longer;
    if (const auto loss = loss_of(report)) losses.push_back(*loss);
  }
  const auto count = static_cast<int>(times.size());
  if (count == 0) return "";
  std::string text = summary_line(
      {number(median(times), 3), number(median(without), 3), percent(median(gains)), number(median(small), 3),
       percent(median(small_gains)), number(median(cells), 0), number(median(fewest), 0), "-"},
      "median of " + counted(count, "maze", "mazes"));
  text += fmt::format("\nIn {} of them ({:.1f} %) the fastest route enters more cells than necessary", longer,
                      100.0 * longer / count);
  if (losses.empty()) return text + ".\n";
  double sum = 0.0;
  for (const double loss : losses) sum += loss;
  return text +
         fmt::format(
             "; there, the fastest route through the fewest cells is {:.1f} % slower on average, {:.1f} % at most.\n",
             100.0 * sum / static_cast<double>(losses.size()), 100.0 * *std::max_element(losses.begin(), losses.end()));
}

std::string robot_text(const DriveModel& model) {
  return fmt::format("{}, cells of {:g} mm", shown(model.robot.name), model.tables.cell);
}

/// Where and how a run begins.
std::string start_text(const Robot& robot) {
  if (robot.fixed) return fmt::format("{:g} mm/s in the centre of the start", robot.fixed->speed);
  if (robot.run_up == 0.0) return "rest in the centre of the start";
  return fmt::format("rest {:g} mm behind the centre of the start", robot.run_up);
}

}  // namespace

std::string table_of(const RouteReport& report, const NamedMaze& maze, const DriveModel& model) {
  const std::string steps = notation_of(report.route, model.tables);
  return fmt::format(
             "{}: the fastest route of {}\n\n{}\n{}{}{:.3f} s from {} to the centre of the goal, {:.3f} s gate to "
             "gate\n",
             shown(maze.name), robot_text(model), segments_text(report.route, model), steps,
             steps.empty() ? "" : "\n\n", seconds(report.route.time), start_text(model.robot),
             seconds(report.gate_to_gate)) +
         gains_text(report) + fewest_text(report);
}

std::string summary_of(const std::vector<RouteReport>& reports, const std::vector<NamedMaze>& mazes,
                       const DriveModel& model) {
  std::string text = fmt::format("The fastest routes of {}: seconds from {} to the centre of the goal\n\n",
                                 robot_text(model), start_text(model.robot));
  text += summary_line({"fastest", "without", "", "S90", "", "cells", "fewest", "fewest"}, "");
  text += summary_line({"route", "diag.", "gain %", "alone", "gain %", "entered", "cells", "+ %"}, "maze");
  for (std::size_t i = 0; i < reports.size(); ++i) text += line_of(reports[i], mazes[i]);
  return text + medians_text(reports);
}

}  // namespace labmouse
