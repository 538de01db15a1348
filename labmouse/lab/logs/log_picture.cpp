// A log beside a robot, as a picture.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/functions/angles.hpp"
#include "labmouse/hardware/sense.hpp"
#include "labmouse/lab/drawing/legend.hpp"
#include "labmouse/lab/drawing/palette.hpp"
#include "labmouse/lab/drawing/plot_area.hpp"
#include "labmouse/lab/drawing/sheet.hpp"
#include "labmouse/lab/logs/log_comparison.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using namespace drawing;

// Pixels.
constexpr int plot_left = 76, plot_width = 760, plot_top = 56, plot_height = 150, plot_step = plot_height + 66;

struct CurvePanel {
  std::string_view label;
  const ComparedCurve& curve;
  double unit;
};

/// A line through at most so many points of a curve as pixels tell.
std::string curve_svg(const std::vector<double>& values, double unit, const Axis& x, const Axis& y, const Tone& tone) {
  const std::size_t step = std::max<std::size_t>(1, values.size() / (2 * plot_width));
  std::string data;
  for (std::size_t i = 0; i < values.size(); i += step)
    data += fmt::format("{}{:.1f} {:.1f}", data.empty() ? "M" : "L", x.place(static_cast<double>(i) * tick_seconds),
                        y.place(unit * values[i]));
  return fmt::format("<path {} stroke-width=\"1.5\" stroke-opacity=\"0.85\" d=\"{}\"/>\n", stroke(tone), data);
}

std::string panel_svg(const CurvePanel& panel, int top) {
  const PlotArea area{plot_left, top, plot_left + plot_width, top + plot_height};
  double low = 0.0, high = 0.0;
  for (const std::vector<double>* values : {&panel.curve.log, &panel.curve.robot})
    for (const double value : *values) {
      low = std::min(low, panel.unit * value);
      high = std::max(high, panel.unit * value);
    }
  const double room = high > low ? 0.06 * (high - low) : 0.5;
  const Axis x(0.0, static_cast<double>(panel.curve.log.size()) * tick_seconds, area.left, area.right, 10);
  const Axis y(low - room, high + room, area.bottom, area.top, 5);
  const double parting = panel.curve.parts ? x.place(static_cast<double>(*panel.curve.parts) * tick_seconds) : 0.0;
  return axes_svg(area, x, y, "s", panel.label) +
         (panel.curve.parts ? line_svg(parting, area.top, parting, area.bottom, muted, 1) : "") +
         curve_svg(panel.curve.log, panel.unit, x, y, to_goal) + curve_svg(panel.curve.robot, panel.unit, x, y, route);
}

std::string sample(const Tone& tone) { return line_svg(0, 0, 20, 0, tone, 2); }

}  // namespace

std::string picture_of(const LogComparison& comparison, std::string_view log_name, std::string_view robot_name) {
  const std::array<CurvePanel, 4> panels = {{{"speed, mm/s", comparison.speed, 1.0},
                                             {"yaw speed, rad/s", comparison.yaw, 1.0},
                                             {"way, mm", comparison.way, 1.0},
                                             {"turn, degrees", comparison.turn, 180.0 / pi}}};
  std::string svg;
  int top = plot_top;
  for (const CurvePanel& panel : panels) {
    if (panel.curve.log.empty()) continue;
    svg += panel_svg(panel, top);
    top += plot_step;
  }
  const int right = plot_left + plot_width;
  Legend legend({plot_left, top}, right);
  legend.add(20, sample(to_goal), fmt::format("the log {}", log_name));
  legend.add(20, sample(route), fmt::format("the robot {}", robot_name));
  if (std::any_of(panels.begin(), panels.end(), [](const CurvePanel& panel) { return panel.curve.parts.has_value(); }))
    legend.add(2, line_svg(1, -7, 1, 7, muted, 1), "where they part");
  const std::string title = fmt::format("{} beside {}", log_name, robot_name);
  const std::string words = fmt::format("What the log shows, what the robot does {}, and where the two part.",
                                        comparison.by_duties ? "by the same duties" : "after the same speeds");
  const Sheet sheet{right + 24, legend.bottom() + 12, title, words};
  return sheet.with(heading_svg({plot_left, 32}, right, title) + svg + legend.svg());
}

}  // namespace labmouse
