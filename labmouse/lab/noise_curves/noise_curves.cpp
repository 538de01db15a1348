#include "labmouse/lab/noise_curves/noise_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// The noise factor of a world; nullopt where it has none.
std::optional<double> noise_of(const World& world) {
  for (const Condition& condition : world.conditions())
    if (condition.key == "noise") return number_of(condition.value);
  return std::nullopt;
}

void add(const Race& race, const ContestResult& contest, NoisePoint& point) {
  ++point.contests;
  point.finished += contest.score ? 1 : 0;
  point.par1 = point.par1.value_or(0.0) + number_of(figure_of(race, contest, "par1")).value_or(0.0);
  const Value by = figure_of(race, contest, "ended_by");
  const auto* name = std::get_if<std::string>(&by);
  for (const RunEnd end : all_run_ends)
    if (name != nullptr && *name == name_of(end)) ++point.ended[static_cast<std::size_t>(end)];
}

std::vector<NoisePoint> points_of(const Race& race, double noise) {
  std::vector<NoisePoint> points(race.mice.size());
  std::vector<std::vector<MazeSum>> finished(race.mice.size(), std::vector<MazeSum>(race.mazes.size()));
  for (const ContestResult& contest : race.results) {
    if (!counts(race, contest)) continue;
    add(race, contest, points[contest.mouse]);
    MazeSum& maze = finished[contest.mouse][contest.maze];
    maze.sum += contest.score ? 1.0 : 0.0;
    maze.count += 1.0;
  }
  for (std::size_t mouse = 0; mouse < points.size(); ++mouse) {
    NoisePoint& point = points[mouse];
    point.noise = noise;
    point.interval = share_interval(finished[mouse]);
    if (point.par1) *point.par1 /= point.contests;
  }
  return points;
}

double share_finished(const NoiseCurve& curve) {
  double sum = 0.0;
  for (const NoisePoint& point : curve.points) sum += point.contests > 0 ? 1.0 * point.finished / point.contests : 0.0;
  return sum;
}

std::size_t name_width(std::span<const NoiseCurve> curves) {
  std::size_t width = 5;
  for (const NoiseCurve& curve : curves) width = std::max(width, shown(curve.mouse).size());
  return width;
}

/// A line for each mouse with a text for each noise.
template <class Text>
std::string lines_of(std::span<const NoiseCurve> curves, std::string_view title, Text text) {
  const std::size_t width = name_width(curves);
  std::string lines = fmt::format("{}\n{:<{}}", title, "noise", width);
  for (const NoisePoint& point : curves.front().points)
    lines += fmt::format(" {:>16}", fmt::format("{:g}", point.noise));
  for (const NoiseCurve& curve : curves) {
    lines += fmt::format("\n{:<{}}", shown(curve.mouse), width);
    for (const NoisePoint& point : curve.points) lines += fmt::format(" {:>16}", text(point));
  }
  return lines + "\n";
}

std::string finished_text(const NoisePoint& point) {
  if (point.contests == 0) return "-";
  const Interval& interval = point.interval;
  return fmt::format("{:.1f} ({:.1f}-{:.1f})", 100.0 * point.finished / point.contests, 100.0 * interval.low,
                     100.0 * interval.high);
}

}  // namespace

std::vector<NoiseCurve> noise_curves(std::span<const Race> races) {
  std::vector<std::pair<double, const Race*>> by_noise;
  for (const Race& race : races)
    if (const auto noise = noise_of(race.world()); noise && !race.mice.empty()) by_noise.emplace_back(*noise, &race);
  if (by_noise.size() < 2) return {};
  std::stable_sort(by_noise.begin(), by_noise.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  if (std::adjacent_find(by_noise.begin(), by_noise.end(), same) != by_noise.end()) return {};
  std::vector<NoiseCurve> curves;
  for (const Contestant& mouse : by_noise.front().second->mice) curves.push_back({mouse.name, {}});
  for (const auto& [noise, race] : by_noise) {
    const std::vector<NoisePoint> points = points_of(*race, noise);
    for (std::size_t mouse = 0; mouse < curves.size(); ++mouse) curves[mouse].points.push_back(points[mouse]);
  }
  std::stable_sort(curves.begin(), curves.end(),
                   [](const NoiseCurve& a, const NoiseCurve& b) { return share_finished(a) > share_finished(b); });
  return curves;
}

std::string table_of(std::span<const NoiseCurve> curves, const World& world) {
  std::string text = lines_of(curves, "Finished, % of contests (95 %)", finished_text);
  text += "\n" +
          lines_of(curves,
                   fmt::format("Mean score in {0}; a failed contest counts {1:g}", world.unit(), world.limit_score()),
                   [](const NoisePoint& point) { return point.par1 ? fmt::format("{:.3f}", *point.par1) : "-"; });
  for (const RunEnd end : all_run_ends) {
    const auto place = static_cast<std::size_t>(end);
    const auto any = [&](const NoiseCurve& curve) {
      return std::any_of(curve.points.begin(), curve.points.end(),
                         [&](const NoisePoint& point) { return point.ended[place] > 0; });
    };
    if (std::none_of(curves.begin(), curves.end(), any)) continue;
    text += "\n" + lines_of(curves, fmt::format("Number of runs that ended otherwise: {}", name_of(end)),
                            [&](const NoisePoint& point) { return fmt::format("{}", point.ended[place]); });
  }
  return text;
}

}  // namespace labmouse
