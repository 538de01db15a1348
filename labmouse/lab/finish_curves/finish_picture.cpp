// Draws curves: the share finished by each mouse, and bars of what ended the other contests.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/lab/drawing/legend.hpp"
#include "labmouse/lab/drawing/palette.hpp"
#include "labmouse/lab/drawing/plot_area.hpp"
#include "labmouse/lab/drawing/sheet.hpp"
#include "labmouse/lab/finish_curves/finish_curves.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using namespace drawing;

// Pixels.
constexpr int left_edge = 76, top_edge = 56, chart_width = 460, chart_height = 320, name_room = 220, bar_width = 420,
              bar_height = 16, bar_step = 24, side_margin = 24, letters_of_a_name = 26;
constexpr PlotArea chart = {left_edge, top_edge, left_edge + chart_width, top_edge + chart_height};
constexpr int right_edge = chart.right + name_room;

/// From the sixth mouse on, colours repeat with dashed lines.
constexpr std::array<const Tone*, 5> tones = {&route, &to_goal, &onwards, &wrong, &candidate};
constexpr std::array<std::string_view, 3> dashes = {"", " stroke-dasharray=\"7 4\"", " stroke-dasharray=\"2 4\""};

std::string line_style(std::size_t mouse) {
  return stroke(*tones[mouse % tones.size()]) + std::string(dashes[mouse / tones.size() % dashes.size()]);
}

double percent_of(const FinishPoint& point) {
  return point.contests > 0 ? 100.0 * point.finished / point.contests : 0.0;
}

std::string curve_svg(const FinishCurve& curve, std::size_t mouse, const Axis& x, const Axis& y) {
  std::string data, whiskers;
  for (const FinishPoint& point : curve.points) {
    data += fmt::format("{}{:.1f} {:.1f}", data.empty() ? 'M' : 'L', x.place(point.at), y.place(percent_of(point)));
    const Interval& interval = point.interval;
    whiskers += fmt::format("<path {} stroke-opacity=\"0.5\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n",
                            stroke(*tones[mouse % tones.size()]), x.place(point.at), y.place(100.0 * interval.low),
                            y.place(100.0 * interval.high));
  }
  return whiskers + fmt::format("<path {} stroke-width=\"2\" d=\"{}\"><title>{}</title></path>\n", line_style(mouse),
                                data, xml_escaped(curve.mouse));
}

/// Names at the ends of the curves, moved apart where they would lie upon each other.
std::string names_svg(const FinishCurves& curves, const Axis& y) {
  constexpr double least_step = 16.0;
  std::vector<std::pair<double, std::size_t>> ends;
  for (std::size_t mouse = 0; mouse < curves.curves.size(); ++mouse)
    ends.emplace_back(y.place(percent_of(curves.curves[mouse].points.back())), mouse);
  std::stable_sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i].first = std::max(ends[i].first, ends[i - 1].first + least_step);
  // Move names that fell below the chart back up, and those above them too.
  for (std::size_t i = ends.size(); i-- > 0;)
    ends[i].first = std::min(ends[i].first, i + 1 < ends.size() ? ends[i + 1].first - least_step : 1.0 * chart.bottom);
  std::string svg;
  for (const auto& [at, mouse] : ends) {
    svg += fmt::format("<path {} stroke-width=\"2\" d=\"M{} {:.1f}h22\"/>\n", line_style(mouse), chart.right + 10, at);
    svg += text_svg(chart.right + 38, at + 4, "start", ink, fitted(curves.curves[mouse].mouse, letters_of_a_name));
  }
  return svg;
}

/// Reasons why a contest ended unfinished.
constexpr std::array ends_shown = {RunEnd::slid,          RunEnd::position_lost, RunEnd::wall_error,
                                   RunEnd::no_route_left, RunEnd::given_up,      RunEnd::out_of_time};
const Tone& tone_of(RunEnd end) {
  constexpr std::array<const Tone*, ends_shown.size()> of = {&candidate, &route, &wrong, &to_goal, &faint, &muted};
  const auto place = std::find(ends_shown.begin(), ends_shown.end(), end) - ends_shown.begin();
  return *of[static_cast<std::size_t>(place)];
}

std::string rect_svg(double x, double y, double width, const Tone& tone, std::string_view words) {
  return fmt::format("<path {} d=\"M{:.1f} {:.1f}h{:.1f}v{}h{:.1f}Z\"><title>{}</title></path>\n", fill(tone), x, y,
                     width, bar_height, -width, xml_escaped(words));
}

/// A bar for each mouse at one scale: contests finished, and what ended the others.
std::string bars_svg(const FinishCurves& curves, std::size_t place, int top) {
  std::string svg =
      text_svg(left_edge, top - 14, "start", ink,
               fmt::format("What ended the others at noise {:g}", curves.curves.front().points[place].at));
  for (std::size_t mouse = 0; mouse < curves.curves.size(); ++mouse) {
    const FinishPoint& point = curves.curves[mouse].points[place];
    const double y = top + static_cast<double>(mouse) * bar_step, unit = 1.0 * bar_width / std::max(1, point.contests);
    double x = left_edge + 160;
    svg += text_svg(x - 8, y + bar_height - 4, "end", ink, fitted(curves.curves[mouse].mouse, letters_of_a_name - 4));
    svg += rect_svg(x, y, unit * point.finished, goal, fmt::format("finished {}", point.finished));
    x += unit * point.finished;
    for (const RunEnd end : ends_shown) {
      const int count = point.ended[static_cast<std::size_t>(end)];
      if (count == 0) continue;
      svg += rect_svg(x, y, unit * count, tone_of(end), fmt::format("{} {}", name_of(end), count));
      x += unit * count;
    }
  }
  return svg;
}

/// The index of the scale for the bars: the one nearest to that of a contest.
std::size_t usual_place(const FinishCurve& curve) {
  constexpr double usual = 1.0;
  std::size_t best = 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    if (std::abs(curve.points[i].at - usual) < std::abs(curve.points[best].at - usual)) best = i;
  return best;
}

Legend legend_of(const FinishCurves& curves, std::size_t place, int top) {
  Legend legend({left_edge, top}, right_edge);
  const auto sample = [](const Tone& tone) { return fmt::format("<path {} d=\"M0 -6h12v12h-12Z\"/>", fill(tone)); };
  legend.add(12, sample(goal), "finished");
  for (const RunEnd end : ends_shown)
    if (std::any_of(curves.curves.begin(), curves.curves.end(), [&](const FinishCurve& curve) {
          return curve.points[place].ended[static_cast<std::size_t>(end)] > 0;
        }))
      legend.add(12, sample(tone_of(end)), name_of(end));
  return legend;
}

}  // namespace

std::string draw_curves(const FinishCurves& curves, const std::string& title) {
  const double last = curves.curves.front().points.back().at;
  const Axis x(0.0, last > 0.0 ? 1.02 * last : 1.0, chart.left, chart.right, 8);
  const Axis y(0.0, 100.0, chart.bottom, chart.top, 10);
  const std::size_t place = usual_place(curves.curves.front());
  const int bars = chart.bottom + 92, bars_end = bars + static_cast<int>(curves.curves.size()) * bar_step;
  const Legend legend = legend_of(curves, place, bars_end + 16);
  const Sheet sheet = {
      right_edge + side_margin,
      legend.bottom() + side_margin / 2,
      title,
      fmt::format("The share of contests that mice finish against the scale of the {}, a line a mouse with 95 % "
                  "intervals; below, what ended the contests that they did not finish.",
                  curves.scale),
      {candidate, wrong}};
  std::string svg = heading_svg({left_edge, 32}, right_edge, title) +
                    axes_svg(chart, x, y, fmt::format("scale of the {}", curves.scale), "contests finished, %");
  for (std::size_t mouse = 0; mouse < curves.curves.size(); ++mouse)
    svg += curve_svg(curves.curves[mouse], mouse, x, y);
  return sheet.with(svg + names_svg(curves, y) + bars_svg(curves, place, bars) + legend.svg());
}

}  // namespace labmouse
