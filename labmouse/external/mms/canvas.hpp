// Drawing of an mms mouse on its maze: walls, colours and texts. It has no effect on the contest.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "labmouse/grid/cell.hpp"
#include "labmouse/grid/heading.hpp"

namespace labmouse {

/// The colour letters of setColor.
inline constexpr std::string_view mms_colours = "kbacgorwyBCAGORVY";

/// The drawing of one mouse. Cells must lie inside of the maze.
class MmsCanvas {
 public:
  /// mms shows two rows of five characters per cell; longer texts are cut.
  static constexpr std::size_t text_columns = 5, text_rows = 2;

  MmsCanvas() = default;
  explicit MmsCanvas(Size size) : size_(size), cells_(static_cast<std::size_t>(size.area())) {}

  Size size() const { return size_; }

  /// Whether the mouse drew a wall on that side of that cell; the border counts like all others.
  bool has_wall(Cell cell, Heading side) const;
  /// Draws or removes it, on both of its sides.
  void set_wall(Cell cell, Heading side, bool there);

  /// One of mms_colours, or 0 for none.
  char colour(Cell cell) const { return at(cell).colour; }
  void set_colour(Cell cell, char colour) { at(cell).colour = colour; }
  void clear_colours();

  /// Printable ASCII, at most text_columns * text_rows characters: row by row, without separators.
  std::string_view text(Cell cell) const { return {at(cell).text.data(), at(cell).length}; }
  /// Sets the text of a cell from UTF-8. As in mms, a backslash and each character outside of printable ASCII becomes
  /// `?`. An empty text clears the cell.
  void set_text(Cell cell, std::string_view text);
  void clear_texts();

  friend bool operator==(const MmsCanvas&, const MmsCanvas&) = default;

 private:
  struct Drawing {
    std::uint8_t walls = 0;  ///< bit by Heading
    char colour = 0;
    std::uint8_t length = 0;
    std::array<char, text_columns * text_rows> text{};

    friend bool operator==(const Drawing&, const Drawing&) = default;
  };
  Drawing& at(Cell cell) { return cells_[static_cast<std::size_t>(size_.index(cell))]; }
  const Drawing& at(Cell cell) const { return cells_[static_cast<std::size_t>(size_.index(cell))]; }
  void set_side(Cell cell, Heading side, bool there);

  Size size_;
  std::vector<Drawing> cells_;
};

}  // namespace labmouse
