#include "labmouse/maze/formats/problem_list.hpp"

#include "labmouse/maze/formats/text.hpp"

namespace labmouse::formats {
namespace {

// Long enough for any number or wall that could have been meant, short enough for a line on a terminal.
constexpr std::size_t longest_quote = 20;

void append_printable(std::string& text, char letter) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(letter);
  if (byte >= 0x20 && byte < 0x7F) {
    text += letter;
  } else {
    text += "\\x";
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
}

}  // namespace

ReadResult failure(int line, int column, std::string reason) {
  return {std::nullopt, {{line, column, std::move(reason)}}};
}

ReadResult map_of(const Maze& known, const WallSet& unseen) {
  if (unseen.empty()) return {.maze = known};
  ReadResult result = failure(0, 0,
                              joined("a partial map: ", unseen.count(), " of ", WallSet::all(known.size()).count(),
                                     " inner walls were not seen; `labmouse inspect FILE --against MAZE` compares it"));
  result.partial = PartialMap{known, unseen};
  return result;
}

std::string name_of(Cell cell) { return "(" + std::to_string(cell.x) + "," + std::to_string(cell.y) + ")"; }

std::string quoted(std::string_view text) {
  std::string quote = "'";
  for (const char letter : text.substr(0, longest_quote)) append_printable(quote, letter);
  if (text.size() > longest_quote) quote += "...";
  return quote + "'";
}

std::string open_border(Cell cell, Heading side) {
  return "cell " + name_of(cell) + " is open to the " + std::string(labmouse::name_of(side)) +
         " but the border of a maze must be closed";
}

}  // namespace labmouse::formats
