// The sheet of an SVG picture: title, description, ground and colours, without which no picture goes out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/drawing/frame.hpp"
#include "labmouse/lab/drawing/palette.hpp"

namespace labmouse::drawing {

/// Pixels, of a sheet with one maze; small mazes have titles and legends, too.
inline constexpr int sheet_margin = 20, least_sheet_width = 300;

struct Sheet {
  int width = 0;
  int height = 0;
  /// What a reader of screens says: the title, and what the picture shows in words.
  std::string title;
  std::string description;
  /// Tones of the picture beyond those that every sheet has.
  std::vector<Tone> tones = {};

  /// The whole file with that SVG on the sheet.
  std::string with(std::string_view svg) const;
};

/// The words, printable; where they have more than so many letters (at least 1), cut and ended by an ellipsis.
std::string fitted(std::string_view words, int letters);

/// A heading from there on to the right, cut where it would pass `right`, before its last colon if possible, so that an
/// outcome behind it stays; nothing for an empty one.
std::string heading_svg(Point begin, int right, std::string_view words);

}  // namespace labmouse::drawing
