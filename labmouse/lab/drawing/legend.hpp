// The legend of an SVG picture: samples with words, in rows that break where the picture ends.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/drawing/frame.hpp"

namespace labmouse::drawing {

class Legend {
 public:
  /// @param begin Left end of the first row, at half its height. @param right Rows break before this x.
  Legend(Point begin, int right) : begin_(begin), pen_(begin), right_(right) {}

  /// Adds an entry. The sample is SVG; the middle of its left side is at (0,0).
  void add(int sample_width, std::string_view sample, std::string_view words);

  const std::string& svg() const { return svg_; }
  /// The lower end of the rows.
  int bottom() const { return pen_.y + row_height / 2; }

 private:
  static constexpr int row_height = 26;

  Point begin_;
  Point pen_;
  int right_;
  std::string svg_;
};

}  // namespace labmouse::drawing
