#include "labmouse/lab/drawing/plot_area.hpp"

#include <fmt/format.h>

#include "labmouse/lab/drawing/sheet.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse::drawing {

std::string line_svg(double x1, double y1, double x2, double y2, const Tone& tone, int width) {
  return fmt::format("<path {} stroke-width=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", stroke(tone), width, x1, y1,
                     x2, y2);
}

std::string text_svg(double x, double y, std::string_view anchor, const Tone& tone, std::string_view words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y, anchor, fill(tone),
                     xml_escaped(words));
}

std::string axes_svg(const PlotArea& area, const Axis& x, const Axis& y, std::string_view x_label,
                     std::string_view y_label) {
  std::string svg;
  for (const Axis::Tick& tick : y.ticks())
    svg += line_svg(area.left, tick.at, area.right, tick.at, post, 1) +
           text_svg(area.left - 8, tick.at + 4, "end", muted, tick.label);
  for (const Axis::Tick& tick : x.ticks())
    svg += line_svg(tick.at, area.bottom, tick.at, area.bottom + 5, ink, 1) +
           text_svg(tick.at, area.bottom + 20, "middle", muted, tick.label);
  svg += line_svg(area.left, area.bottom, area.right, area.bottom, ink, 1) +
         line_svg(area.left, area.top, area.left, area.bottom, ink, 1);
  const int side = area.left - 56, middle = (area.top + area.bottom) / 2;
  return svg +
         text_svg((area.left + area.right) / 2.0, area.bottom + 42, "middle", ink,
                  fitted(x_label, (area.right - area.left) / letter_width)) +
         fmt::format("<g transform=\"rotate(-90 {} {})\">\n{}</g>\n", side, middle,
                     text_svg(side, middle, "middle", ink, fitted(y_label, (area.bottom - area.top) / letter_width)));
}

}  // namespace labmouse::drawing
