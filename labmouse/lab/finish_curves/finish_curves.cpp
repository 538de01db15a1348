#include "labmouse/lab/finish_curves/finish_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// The scales of the errors that a race may have a list of.
constexpr std::array<std::string_view, 2> scales = {"noise", "variation"};

/// That scale of a world; nullopt where it has none.
std::optional<double> scale_of(const World& world, std::string_view scale) {
  for (const Condition& condition : world.traits().conditions)
    if (condition.key == scale) return number_of(condition.value);
  return std::nullopt;
}

/// The one scale by which the races differ; empty if there is none, or both do.
std::string_view varied_scale(std::span<const Race> races) {
  std::string_view varied;
  for (const std::string_view scale : scales) {
    const auto first = scale_of(races.front().world(), scale);
    const auto same = [&](const Race& race) { return scale_of(race.world(), scale) == first; };
    if (std::all_of(races.begin(), races.end(), same)) continue;
    if (!varied.empty()) return {};
    varied = scale;
  }
  return varied;
}

void add(const Race& race, const ContestResult& contest, FinishPoint& point) {
  ++point.contests;
  point.finished += contest.score ? 1 : 0;
  point.par1 = point.par1.value_or(0.0) + number_of(figure_of(race, contest, "par1")).value_or(0.0);
  const Value by = figure_of(race, contest, "ended_by");
  const auto* name = std::get_if<std::string>(&by);
  for (const RunEnd end : all_run_ends)
    if (name != nullptr && *name == name_of(end)) ++point.ended[static_cast<std::size_t>(end)];
}

std::vector<FinishPoint> points_of(const Race& race, double scale) {
  std::vector<FinishPoint> points(race.mice.size());
  std::vector<std::vector<MazeSum>> finished(race.mice.size(), std::vector<MazeSum>(race.mazes.size()));
  for (const ContestResult& contest : race.results) {
    if (!counts(race, contest)) continue;
    add(race, contest, points[contest.mouse]);
    MazeSum& maze = finished[contest.mouse][contest.maze];
    maze.sum += contest.score ? 1.0 : 0.0;
    maze.count += 1.0;
  }
  for (std::size_t mouse = 0; mouse < points.size(); ++mouse) {
    FinishPoint& point = points[mouse];
    point.at = scale;
    point.interval = share_interval(finished[mouse]);
    if (point.par1) *point.par1 /= point.contests;
  }
  return points;
}

double share_finished(const FinishCurve& curve) {
  double sum = 0.0;
  for (const FinishPoint& point : curve.points) sum += point.contests > 0 ? 1.0 * point.finished / point.contests : 0.0;
  return sum;
}

std::size_t name_width(const FinishCurves& curves) {
  std::size_t width = 5;
  for (const FinishCurve& curve : curves.curves) width = std::max(width, shown(curve.mouse).size());
  return width;
}

/// A line for each mouse with a text for each scale.
template <class Text>
std::string lines_of(const FinishCurves& curves, std::string_view title, Text text) {
  const std::size_t width = name_width(curves);
  std::string lines = fmt::format("{}\n{:<{}}", title, curves.scale, width);
  for (const FinishPoint& point : curves.curves.front().points)
    lines += fmt::format(" {:>16}", fmt::format("{:g}", point.at));
  for (const FinishCurve& curve : curves.curves) {
    lines += fmt::format("\n{:<{}}", shown(curve.mouse), width);
    for (const FinishPoint& point : curve.points) lines += fmt::format(" {:>16}", text(point));
  }
  return lines + "\n";
}

std::string finished_text(const FinishPoint& point) {
  if (point.contests == 0) return "-";
  const Interval& interval = point.interval;
  return fmt::format("{:.1f} ({:.1f}-{:.1f})", 100.0 * point.finished / point.contests, 100.0 * interval.low,
                     100.0 * interval.high);
}

}  // namespace

FinishCurves finish_curves(std::span<const Race> races) {
  FinishCurves curves;
  if (races.empty()) return curves;
  curves.scale = varied_scale(races);
  std::vector<std::pair<double, const Race*>> by_scale;
  for (const Race& race : races)
    if (const auto scale = scale_of(race.world(), curves.scale); scale && !race.mice.empty())
      by_scale.emplace_back(*scale, &race);
  if (by_scale.size() < 2) return curves;
  std::stable_sort(by_scale.begin(), by_scale.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  if (std::adjacent_find(by_scale.begin(), by_scale.end(), same) != by_scale.end()) return curves;
  for (const Contestant& mouse : by_scale.front().second->mice) curves.curves.push_back({mouse.name, {}});
  for (const auto& [scale, race] : by_scale) {
    const std::vector<FinishPoint> points = points_of(*race, scale);
    for (std::size_t mouse = 0; mouse < points.size(); ++mouse) curves.curves[mouse].points.push_back(points[mouse]);
  }
  std::stable_sort(curves.curves.begin(), curves.curves.end(),
                   [](const FinishCurve& a, const FinishCurve& b) { return share_finished(a) > share_finished(b); });
  return curves;
}

std::string table_of(const FinishCurves& curves, const World& world) {
  std::string text = lines_of(curves, "Finished, % of contests (95 %)", finished_text);
  text +=
      "\n" + lines_of(curves,
                      fmt::format("Mean score in {0}; a failed contest counts {1:g}", world.traits().unit,
                                  world.traits().limit_score),
                      [](const FinishPoint& point) { return point.par1 ? fmt::format("{:.3f}", *point.par1) : "-"; });
  for (const RunEnd end : all_run_ends) {
    const auto place = static_cast<std::size_t>(end);
    const auto any = [&](const FinishCurve& curve) {
      return std::any_of(curve.points.begin(), curve.points.end(),
                         [&](const FinishPoint& point) { return point.ended[place] > 0; });
    };
    if (std::none_of(curves.curves.begin(), curves.curves.end(), any)) continue;
    text += "\n" + lines_of(curves, fmt::format("Number of runs that ended otherwise: {}", name_of(end)),
                            [&](const FinishPoint& point) { return fmt::format("{}", point.ended[place]); });
  }
  return text;
}

}  // namespace labmouse
