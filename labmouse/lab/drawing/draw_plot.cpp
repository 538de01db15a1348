// Plots as self-contained SVG files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/lab/drawing/axis.hpp"
#include "labmouse/lab/drawing/legend.hpp"
#include "labmouse/lab/drawing/palette.hpp"
#include "labmouse/lab/drawing/plot.hpp"
#include "labmouse/lab/drawing/plot_area.hpp"
#include "labmouse/lab/drawing/sheet.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {
namespace {

using namespace drawing;

// Pixels: the plot area and the space around it.
constexpr int left = 76, top = 56, least_width = 560, height = 320, margin = 24;
constexpr int bottom = top + height;

/// The points sorted by their numbers, or in the given order if one has no number.
struct Row {
  std::vector<const PlotPoint*> points;
  std::vector<double> values;  ///< on the axis, of each point
  bool numbers = true;
};

Row row_of(const Plot& plot) {
  Row row;
  std::vector<std::pair<double, const PlotPoint*>> pairs;
  for (const PlotPoint& point : plot.points) {
    const std::optional<double> number = parse_plain_number(point.x);
    row.numbers = number && row.numbers;
    pairs.emplace_back(number.value_or(0.0), &point);
  }
  if (row.numbers)
    std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [number, point] : pairs) {
    row.values.push_back(row.numbers ? number : static_cast<double>(row.points.size()));
    row.points.push_back(point);
  }
  return row;
}

/// Right edge of the plot. Names stand side by side, so many names need a wide picture.
int right_of(const Row& row) {
  if (row.numbers) return left + least_width;
  std::size_t longest = 0;
  for (const PlotPoint* point : row.points) longest = std::max(longest, point->x.size());
  return left + std::max(least_width, static_cast<int>(row.points.size() * (longest + 2)) * letter_width);
}

Axis x_axis(const Row& row, int right) {
  if (!row.numbers) {
    std::vector<std::string> names;
    for (const PlotPoint* point : row.points) names.push_back(point->x);
    return {names, left, right};
  }
  const double low = row.values.empty() ? 0.0 : row.values.front(), high = row.values.empty() ? 1.0 : row.values.back();
  const double room = high > low ? 0.04 * (high - low) : 0.5;
  const bool whole =
      std::all_of(row.values.begin(), row.values.end(), [](double value) { return value == std::floor(value); });
  return {low - room, high + room, left, right, 10, whole ? 1.0 : 0.0};
}

/// Covers all means and intervals; begins at 0 or above if all of them do.
Axis y_axis(const Row& row) {
  std::vector<double> ends;
  for (const PlotPoint* point : row.points) {
    ends.push_back(point->mean);
    if (point->interval) ends.insert(ends.end(), {point->interval->low, point->interval->high});
  }
  if (ends.empty()) ends = {0.0, 1.0};
  const auto [low, high] = std::minmax_element(ends.begin(), ends.end());
  const double room = *high > *low ? 0.06 * (*high - *low) : 0.5;
  return {*low >= 0.0 ? std::max(0.0, *low - room) : *low - room, *high + room, bottom, top, 10};
}

/// A line from mean to mean; none between names, because there are no values in between.
std::string means_svg(const Row& row, const Axis& x, const Axis& y) {
  if (!row.numbers || row.points.size() < 2) return "";
  std::string data;
  for (std::size_t i = 0; i < row.points.size(); ++i)
    data += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : "L", x.place(row.values[i]), y.place(row.points[i]->mean));
  return fmt::format("<path {} stroke-width=\"2\" stroke-opacity=\"0.8\" d=\"{}\"/>\n", stroke(route), data);
}

/// A whisker at x between two heights.
std::string whisker(double x, double low, double high) {
  return fmt::format(
      "<path {0} stroke-width=\"2\" d=\"M{1:.1f} {4:.1f}H{2:.1f}M{3:.1f} {4:.1f}V{5:.1f}M{1:.1f} {5:.1f}H{2:.1f}\"/>",
      stroke(muted), x - 4, x + 4, x, low, high);
}

std::string dot(double x, double y, bool hollow, std::string_view words) {
  const std::string title = words.empty() ? "" : fmt::format("<title>{}</title>", xml_escaped(words));
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" {} stroke-width=\"2\">{}</circle>", x, y,
                     fill_and_stroke(hollow ? paper : route, route), title);
}

std::string points_svg(const Row& row, const Axis& x, const Axis& y) {
  std::string whiskers, dots;
  for (std::size_t i = 0; i < row.points.size(); ++i) {
    const PlotPoint& point = *row.points[i];
    const double at = x.place(row.values[i]);
    if (point.interval) whiskers += whisker(at, y.place(point.interval->low), y.place(point.interval->high)) + "\n";
    dots += dot(at, y.place(point.mean), point.hollow, point.words) + "\n";
  }
  return whiskers + means_svg(row, x, y) + dots;
}

Legend legend_of(const Plot& plot, int right) {
  const auto any = [&](auto has) { return std::any_of(plot.points.begin(), plot.points.end(), has); };
  Legend legend({left, bottom + 72}, right);
  if (any([](const PlotPoint& point) { return !point.hollow; })) legend.add(10, dot(5, 0, false, ""), plot.mean_words);
  if (any([](const PlotPoint& point) { return point.hollow; })) legend.add(10, dot(5, 0, true, ""), plot.hollow_words);
  if (any([](const PlotPoint& point) { return point.interval.has_value(); }))
    legend.add(10, whisker(5, 8, -8), plot.interval_words);
  return legend;
}

}  // namespace

std::string draw_plot(const Plot& plot) {
  const Row row = row_of(plot);
  const int right = right_of(row);
  const Axis x = x_axis(row, right), y = y_axis(row);
  const Legend legend = legend_of(plot, right);
  const Sheet sheet = {right + margin, legend.bottom() + margin / 2, plot.title, plot.description};
  return sheet.with(heading_svg({left, 32}, right, plot.title) +
                    axes_svg({left, top, right, bottom}, x, y, plot.x_label, plot.y_label) + points_svg(row, x, y) +
                    legend.svg());
}

}  // namespace labmouse
