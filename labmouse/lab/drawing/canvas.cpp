#include "labmouse/lab/drawing/canvas.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>

#include "labmouse/lab/drawing/heat.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse::drawing {
namespace {

// From the 256 terminal colours: blues of growing lightness, all dark enough for white text.
constexpr std::array<int, Heat::levels + 1> heat_colours = {0, 17, 18, 19, 25, 26, 32};

/// The ANSI code of an ink. Plain text on heat is white, because heat colours are dark.
std::string_view code_of(Ink ink, bool on_heat) {
  switch (ink) {
    case Ink::plain:
      return on_heat ? "97" : "";
    case Ink::dim:
      return "2";
    case Ink::start:
      return "1;94";
    case Ink::goal:
      return "1;32";
    case Ink::route:
      return on_heat ? "1;93" : "33";
    case Ink::mouse:
      return on_heat ? "1;97" : "1";
    case Ink::to_goal:
      return on_heat ? "1;96" : "36";
    case Ink::onwards:
      return on_heat ? "1;92" : "32";
    case Ink::wrong:
      return "1;95";
  }
  return "";
}

/// Whether black text reads better than white on one of the 256 colours: a cube of 6x6x6, and greys after it.
bool is_light(int colour) {
  constexpr int cube = 16, greys = 232, middle_grey = 244;
  if (colour >= greys) return colour >= middle_grey;
  const int place = colour - cube, red = place / 36, green = place / 6 % 6, blue = place % 6;
  return 3 * red + 6 * green + blue > 25;
}

}  // namespace

Canvas::Canvas(int columns, int rows)
    : columns_(columns), rows_(rows), glyphs_(static_cast<std::size_t>(columns * rows)) {}

void Canvas::put(int column, int row, std::u32string_view text, Ink ink) {
  for (const char32_t character : text) {
    Glyph& glyph = at(column++, row);
    glyph.character = character;
    glyph.ink = ink;
  }
}

void Canvas::warm(int column, int row, int columns, int level) {
  for (int offset = 0; offset < columns; ++offset) at(column + offset, row).heat = level;
}

void Canvas::paint(int column, int row, int columns, int colour) {
  for (int offset = 0; offset < columns; ++offset) at(column + offset, row).paint = colour;
}

std::string Canvas::text(bool colours) const {
  std::string text;
  for (int row = 0; row < rows_; ++row) text += line(row, colours) + '\n';
  return text;
}

std::string Canvas::style_of(const Glyph& glyph) {
  if (glyph.paint > 0) return fmt::format("{};48;5;{}", is_light(glyph.paint) ? "30" : "97", glyph.paint);
  const bool on_heat = glyph.heat > 0;
  // Blanks have no ink, so that the colour does not change at them.
  std::string style{code_of(glyph.character == U' ' ? Ink::plain : glyph.ink, on_heat)};
  if (on_heat) style += fmt::format(";48;5;{}", heat_colours[static_cast<std::size_t>(glyph.heat)]);
  return style;
}

std::string Canvas::line(int row, bool colours) const {
  const auto first = glyphs_.begin() + static_cast<std::ptrdiff_t>(index(0, row));
  auto last = first + columns_;
  while (last != first && (last - 1)->character == U' ' && (last - 1)->heat == 0 && (last - 1)->paint == 0) --last;
  std::string line;
  std::string current;
  for (auto glyph = first; glyph != last; ++glyph) {
    const std::string style = colours ? style_of(*glyph) : "";
    if (style != current) line += style.empty() ? "\x1b[0m" : fmt::format("\x1b[0;{}m", style);
    current = style;
    line += utf8({&glyph->character, 1});
  }
  if (!current.empty()) line += "\x1b[0m";
  return line;
}

}  // namespace labmouse::drawing
