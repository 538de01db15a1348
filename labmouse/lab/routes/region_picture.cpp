#include "labmouse/lab/routes/region_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "labmouse/lab/drawing/plot_area.hpp"
#include "labmouse/lab/drawing/scene.hpp"
#include "labmouse/lab/drawing/sheet.hpp"
#include "labmouse/lab/pictures/path_data.hpp"
#include "labmouse/lab/system/file_names.hpp"

namespace labmouse {
namespace {

using namespace drawing;

// Pixels.
constexpr int width = 1080, top = 64, chart_height = 340, panels = 3, panel_gap = 24, caption = 34;
constexpr PlotArea chart = {100, top, width - 60, top + chart_height};
constexpr int panel_width = (width - 2 * sheet_margin - (panels - 1) * panel_gap) / panels;
constexpr int panel_top = chart.bottom + 92;

const Tone& tone_of(int route) {
  static constexpr std::array<const Tone*, 5> tones = {&to_goal, &drawing::route, &onwards, &wrong, &candidate};
  return *tones[static_cast<std::size_t>(route) % tones.size()];
}

/// The range in which a region is drawn: its borders lie midway between its values and those of its neighbours.
struct Stretch {
  double from, to;
};
Stretch stretch_of(const std::vector<RouteRegion>& row, std::size_t i) {
  return {i == 0 ? row[i].from : (row[i - 1].to + row[i].from) / 2.0,
          i + 1 == row.size() ? row[i].to : (row[i].to + row[i + 1].from) / 2.0};
}

std::string label_of(const VariedNumber& number) {
  const std::string unit = unit_of(number);
  return number.key + (unit.empty() ? "" : ", " + unit);
}

std::string area_svg(const Tone& tone, double x1, double y1, double x2, double y2) {
  return fmt::format("<path {} opacity=\"0.45\" d=\"M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}Z\"/>\n", fill(tone), x1, y1, x2,
                     y2, x1);
}

/// The letter of a route, if the area has room for it.
std::string letter_svg(int route, double x1, double x2, double y) {
  return x2 - x1 < 2 * letter_width ? "" : text_svg((x1 + x2) / 2.0, y, "middle", ink, letter_of(route));
}

/// Plots the times over one number, a line for each route, with a strip of the winners.
std::string times_svg(const RouteRegions& regions, const RegionOrder& order) {
  DriveTime least = no_time, most = 0;
  for (const auto& times : regions.times)
    for (const DriveTime time : times) {
      if (time >= no_time) continue;
      least = std::min(least, time);
      most = std::max(most, time);
    }
  const double margin = std::max(0.05 * (most - least), 1e4);
  const Axis x(order.across.from, order.across.to, chart.left, chart.right, 8);
  const Axis y((least - margin) / 1e6, (most + margin) / 1e6, chart.bottom, chart.top, 8);
  std::string svg = axes_svg(chart, x, y, label_of(order.across), "time of the route, s");
  const auto& row = regions.rows.front().regions;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i].route == RouteRegion::refused) continue;
    const Stretch stretch = stretch_of(row, i);
    svg += area_svg(tone_of(row[i].route), x.place(stretch.from), chart.top - 20, x.place(stretch.to), chart.top - 4);
    svg += letter_svg(row[i].route, x.place(stretch.from), x.place(stretch.to), chart.top - 7);
  }
  for (std::size_t route = 0; route < regions.times.size(); ++route) {
    std::string data;
    bool broken = true;
    for (std::size_t i = 0; i < regions.values.size(); ++i) {
      const DriveTime time = regions.times[route][i];
      if (time < no_time)
        data += fmt::format("{}{:.1f} {:.1f}", broken ? 'M' : 'L', x.place(regions.values[i]), y.place(time / 1e6));
      broken = time >= no_time;
    }
    svg += fmt::format("<path {} stroke-width=\"2.5\" stroke-linejoin=\"round\" d=\"{}\"/>\n",
                       stroke(tone_of(static_cast<int>(route))), data);
    if (const DriveTime last = regions.times[route].back(); last < no_time)
      svg += text_svg(chart.right + 8, y.place(last / 1e6) + 4, "start", ink, letter_of(static_cast<int>(route)));
  }
  return svg;
}

/// Maps the winners over two numbers, a band for each value of the second.
std::string map_svg(const RouteRegions& regions, const RegionOrder& order) {
  const double half = (order.along->to - order.along->from) / (2.0 * (order.rows - 1));
  const Axis x(order.across.from, order.across.to, chart.left, chart.right, 8);
  const Axis y(order.along->from - half, order.along->to + half, chart.bottom, chart.top, 8);
  std::string svg;
  for (const RegionRow& row : regions.rows)
    for (std::size_t i = 0; i < row.regions.size(); ++i) {
      const int route = row.regions[i].route;
      if (route == RouteRegion::refused) continue;
      const Stretch stretch = stretch_of(row.regions, i);
      svg += area_svg(tone_of(route), x.place(stretch.from), y.place(row.at + half), x.place(stretch.to),
                      y.place(row.at - half));
    }
  for (std::size_t row = 2; row < regions.rows.size(); row += 5)
    for (std::size_t i = 0; i < regions.rows[row].regions.size(); ++i) {
      const int route = regions.rows[row].regions[i].route;
      if (route == RouteRegion::refused) continue;
      const Stretch stretch = stretch_of(regions.rows[row].regions, i);
      svg += letter_svg(route, x.place(stretch.from), x.place(stretch.to), y.place(regions.rows[row].at) + 4);
    }
  return svg + axes_svg(chart, x, y, label_of(order.across), label_of(*order.along));
}

/// The routes that win in the largest part of the range; of equals, the first ones.
std::vector<int> most_winning(const RouteRegions& regions) {
  std::vector<double> wins(regions.routes.size(), 0.0);
  for (const RegionRow& row : regions.rows)
    for (std::size_t i = 0; i < row.regions.size(); ++i) {
      if (row.regions[i].route == RouteRegion::refused) continue;
      const Stretch stretch = stretch_of(row.regions, i);
      wins[static_cast<std::size_t>(row.regions[i].route)] += stretch.to - stretch.from;
    }
  std::vector<int> routes(wins.size());
  std::iota(routes.begin(), routes.end(), 0);
  std::stable_sort(routes.begin(), routes.end(),
                   [&](int a, int b) { return wins[static_cast<std::size_t>(a)] > wins[static_cast<std::size_t>(b)]; });
  routes.resize(std::min(routes.size(), static_cast<std::size_t>(panels)));
  std::sort(routes.begin(), routes.end());
  return routes;
}

std::string panel_svg(const Maze& maze, const RegionRoute& drawn, int number, int column) {
  const DrawingLayers layers;
  const Scene scene = {maze, layers, Frame{maze.size(), {0, 0}}, Heat(maze.size(), nullptr), {}};
  const int left = sheet_margin + column * (panel_width + panel_gap);
  const double scale =
      static_cast<double>(panel_width) / (std::max(maze.size().width, maze.size().height) * Frame::cell);
  const std::vector<DrivePathPoint> path = path_of(drawn.route, 0, drawn.model);
  const std::string line =
      path.size() < 2 ? ""
                      : fmt::format("<path {} stroke-width=\"8\" stroke-linejoin=\"round\" d=\"{}\"/>\n",
                                    stroke(tone_of(number)), data_through(scene.frame, path, 0, path.size() - 1));
  return text_svg(left, panel_top - 12, "start", ink, fmt::format("{}: {} cells", letter_of(number), drawn.cells)) +
         fmt::format("<g transform=\"translate({} {}) scale({:.4f})\">\n", left, panel_top, scale) + floor_svg(scene) +
         line + walls_svg(scene) + labels_svg(scene) + "</g>\n";
}

}  // namespace

std::string draw_regions(const Maze& maze, const RouteRegions& regions, const RegionOrder& order,
                         const std::string& title) {
  std::string svg = heading_svg({sheet_margin, 32}, width - sheet_margin, title);
  svg += order.along ? map_svg(regions, order) : times_svg(regions, order);
  int column = 0;
  for (const int number : most_winning(regions))
    svg += panel_svg(maze, regions.routes[static_cast<std::size_t>(number)], number, column++);
  const int height = panel_top + panel_width * maze.size().height / std::max(maze.size().width, maze.size().height);
  const Sheet sheet = {
      width,
      height + sheet_margin,
      title,
      fmt::format("{} routes, each of which is the fastest for some of the robots.", regions.routes.size()),
      {}};
  return sheet.with(svg);
}

std::string title_of_regions(const std::string& maze, const std::string& robot) {
  return fmt::format("{}: which route wins, for which {}", stem_of(maze), robot);
}

}  // namespace labmouse
