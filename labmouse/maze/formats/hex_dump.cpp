// Bytes in hexadecimal digits, as xxd and hexdump print a maz file; addresses before and characters behind them are
// skipped.
//
//     0E 0C 09
//     00000000: 0e0c 0903                                ....
#include <algorithm>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/coded_cells.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"
#include "labmouse/maze/formats/text_rows.hpp"

namespace labmouse {
namespace {

using namespace formats;

constexpr std::size_t most_bytes_of_dump = max_side * max_side;

/// The part of a line that holds bytes.
std::string_view bytes_in(std::string_view line) {
  if (const std::size_t colon = line.find(": ");
      colon != std::string_view::npos && is_hexadecimal(line.substr(0, colon)))
    line.remove_prefix(colon + 2);
  else if (const std::size_t end = line.find(' ');
           end >= 7 && end != std::string_view::npos && end <= 8 && is_hexadecimal(line.substr(0, end)))
    line.remove_prefix(end);
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  // The characters are two blanks after the last byte. Groups of bytes can be two blanks apart, too.
  std::size_t from = 0;
  for (;;) {
    const std::size_t gap = line.find("  ", from);
    if (gap == std::string_view::npos) return line;
    const std::size_t next = line.find_first_not_of(blanks, gap);
    const auto words = words_between_blanks(line.substr(std::min(next, line.size())), 1);
    if (words.empty() || words.front().text.size() % 2 != 0 || !is_hexadecimal(words.front().text))
      return line.substr(0, gap);
    from = next;
  }
}

/// The bytes, up to a line that holds only an address, with which hexdump ends; nothing if there is something else or
/// too many of them.
std::optional<std::vector<CodedCells::Entry>> bytes_of(std::string_view content) {
  std::vector<CodedCells::Entry> bytes;
  for (const Line& line : lines_of(content, most_bytes_of_dump + 1)) {
    const std::string_view part = bytes_in(line.text);
    for (const Word& word : words_between_blanks(part, most_bytes_of_dump)) {
      if (word.text.size() % 2 != 0 || word.text.size() > 4 || !is_hexadecimal(word.text)) {
        // hexdump ends with the address behind the last byte
        if (!bytes.empty() && line.text.size() <= 8 && is_hexadecimal(line.text)) return bytes;
        return std::nullopt;
      }
      for (std::size_t i = 0; i < word.text.size(); i += 2) {
        if (bytes.size() == most_bytes_of_dump) return std::nullopt;
        const int column = static_cast<int>(word.text.data() - line.text.data()) + static_cast<int>(i) + 1;
        bytes.push_back({*parse_whole<unsigned>(word.text.substr(i, 2), 16), line.number, column});
      }
    }
  }
  return bytes;
}

/// Words of two or four digits, and several of them in the first line.
bool is_hex_dump(std::string_view content) {
  const std::string_view line = first_line(content);
  return words_between_blanks(bytes_in(line), 2).size() == 2 && bytes_of(content).has_value();
}

ReadResult read_hex_dump(std::string_view content) {
  if (is_blank(content)) return failure(0, 0, "the file is empty");
  auto bytes = bytes_of(content);
  if (!bytes || bytes->empty()) return failure(0, 0, "expected at most 4096 bytes of two hexadecimal digits");
  return maze_of(
      CodedCells{.format = "dump of bytes", .usual = Layout::columns_from_west, .entries = std::move(*bytes)});
}

WriteResult write_hex_dump(const Maze& maze) {
  const auto [width, height] = maze.size();
  if (width != height || width == 1)
    return {std::nullopt, joined("the maze has ", width, "x", height, " cells; a dump holds only squares from 2x2")};
  if (std::string reason = refused_marks(maze); !reason.empty()) return {std::nullopt, std::move(reason)};
  std::string content;
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < height; ++y)
      ((content += '0') += "0123456789ABCDEF"[~open_sides(maze, {x, y}) & all_sides]) += y == height - 1 ? '\n' : ' ';
  return {std::move(content), {}};
}

}  // namespace

constinit const Format dump_format = {
    .name = "dump",
    .summary = "the bytes of a maz file in hexadecimal digits",
    .extension = ".txt",
    .recognises = is_hex_dump,
    .read = read_hex_dump,
    .write = write_hex_dump,
};

}  // namespace labmouse
