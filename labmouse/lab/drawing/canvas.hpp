// Character grid with colours, on which text drawings are made.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace labmouse::drawing {

enum class Ink { plain, dim, start, goal, route, mouse, to_goal, onwards, wrong };

/// A grid of characters, blank at first; row 0 is at the top. All positions must lie on it.
class Canvas {
 public:
  Canvas(int columns, int rows);

  void put(int column, int row, std::u32string_view text, Ink ink = Ink::plain);
  bool blank(int column, int row) const { return at(column, row).character == U' '; }
  /// Sets the heat level (0 for none), a background colour, of a stretch of a row.
  void warm(int column, int row, int columns, int level);

  /// Sets the background of a stretch of a row to one of the 256 terminal colours (0 for none); it replaces heat.
  void paint(int column, int row, int columns, int colour);

  /// The rows without trailing blanks, each ended by a line feed; with ANSI colour codes only if `colours`.
  std::string text(bool colours) const;

 private:
  struct Glyph {
    char32_t character = U' ';
    Ink ink = Ink::plain;
    int heat = 0;
    int paint = 0;
  };

  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * columns_ + column); }
  Glyph& at(int column, int row) { return glyphs_[index(column, row)]; }
  const Glyph& at(int column, int row) const { return glyphs_[index(column, row)]; }
  static std::string style_of(const Glyph& glyph);
  std::string line(int row, bool colours) const;

  int columns_;
  int rows_;
  std::vector<Glyph> glyphs_;
};

}  // namespace labmouse::drawing
