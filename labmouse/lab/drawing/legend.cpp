#include "labmouse/lab/drawing/legend.hpp"

#include <fmt/format.h>

#include "labmouse/lab/drawing/palette.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse::drawing {

void Legend::add(int sample_width, std::string_view sample, std::string_view words) {
  constexpr int gap = 8;
  constexpr int letter_width = 7;  // about the mean of the wider sans-serif faces at 13 pixels
  const int width = sample_width + gap + static_cast<int>(printable(words).size()) * letter_width;
  if (pen_.x > begin_.x && pen_.x + width > right_) pen_ = {begin_.x, pen_.y + row_height};
  svg_ += fmt::format("<g transform=\"translate({} {})\">{}<text x=\"{}\" y=\"5\" {}>{}</text></g>\n", pen_.x, pen_.y,
                      sample, sample_width + gap, fill(muted), xml_escaped(words));
  pen_.x += width + 2 * gap;
}

}  // namespace labmouse::drawing
