#include "labmouse/external/mms/canvas.hpp"

#include <cassert>

namespace labmouse {
namespace {

unsigned bit_of(Heading side) { return 1U << static_cast<unsigned>(side); }

bool continues_a_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// Number of bytes that follow the first byte of a UTF-8 character; 0 if the byte begins none.
std::size_t followers(char first) {
  const auto byte = static_cast<unsigned char>(first);
  if (byte < 0xC2U || byte > 0xF4U) return 0;
  return byte < 0xE0U ? 1 : byte < 0xF0U ? 2 : 3;
}

/// Removes the first character of a non-empty text, and returns it if mms shows it, else `?`.
char next_shown(std::string_view& text) {
  const char first = text.front();
  std::size_t bytes = 1;
  while (bytes <= followers(first) && bytes < text.size() && continues_a_character(text[bytes])) ++bytes;
  text.remove_prefix(bytes);
  return first >= ' ' && first <= '~' && first != '\\' ? first : '?';
}

}  // namespace

bool MmsCanvas::has_wall(Cell cell, Heading side) const { return (at(cell).walls & bit_of(side)) != 0; }

void MmsCanvas::set_side(Cell cell, Heading side, bool there) {
  auto& walls = at(cell).walls;
  walls = static_cast<std::uint8_t>(there ? walls | bit_of(side) : walls & ~bit_of(side));
}

void MmsCanvas::set_wall(Cell cell, Heading side, bool there) {
  assert(size_.contains(cell));
  set_side(cell, side, there);
  if (const Cell behind = neighbour(cell, side); size_.contains(behind)) set_side(behind, opposite(side), there);
}

void MmsCanvas::clear_colours() {
  for (Drawing& drawing : cells_) drawing.colour = 0;
}

void MmsCanvas::set_text(Cell cell, std::string_view text) {
  Drawing& drawing = at(cell);
  drawing.text = {};
  drawing.length = 0;
  while (!text.empty() && drawing.length < drawing.text.size()) drawing.text[drawing.length++] = next_shown(text);
}

void MmsCanvas::clear_texts() {
  for (Drawing& drawing : cells_) {
    drawing.text = {};
    drawing.length = 0;
  }
}

}  // namespace labmouse
