// The frame that every SVG picture has: title, description, background and colours.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/drawing/frame.hpp"
#include "labmouse/lab/drawing/palette.hpp"

namespace labmouse::drawing {

/// In pixels, of a sheet with one maze. The least width leaves room for title and legend of small mazes.
inline constexpr int sheet_margin = 20, least_sheet_width = 300;

struct Sheet {
  int width = 0;
  int height = 0;
  /// Texts for screen readers: the title, and a description of the picture.
  std::string title;
  std::string description;
  /// Tones of the picture beyond those that every sheet has.
  std::vector<Tone> tones = {};

  /// The complete SVG file with these elements on the sheet.
  std::string with(std::string_view svg) const;
};

/// The words, printable; if longer than `letters` (at least 1), cut and ended by an ellipsis.
std::string fitted(std::string_view words, int letters);

/// A heading from `begin` to at most `right`; empty if `words` is. A long one is cut before its last colon if possible,
/// to keep the outcome after it.
std::string heading_svg(Point begin, int right, std::string_view words);

}  // namespace labmouse::drawing
