// Rows of hexadecimal digits, as firmware from Japan prints mazes: one digit for each cell, the northern row first. A
// digit is the sum of the walls 1 north, 2 east, 4 south and 8 west.
//
//     9553
//     aaba
//     c446
#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"
#include "labmouse/maze/formats/text_rows.hpp"

namespace labmouse {
namespace {

using namespace formats;

/// Two rows at least: a single number is the first line of a capstone file.
bool is_hex_rows(std::string_view content) {
  const std::vector<TextRow> rows = text_rows_of(content);
  return rows.size() >= 2 && are_hex_digits(std::span(rows).first(2)) && !are_blocks(rows);
}

ReadResult read_hex_rows(std::string_view content) {
  return read_text_rows(text_rows_of(content), "rows of hexadecimal digits");
}

WriteResult write_hex_rows(const Maze& maze) {
  if (std::string reason = refused_table(maze); !reason.empty()) return {std::nullopt, std::move(reason)};
  std::string content;
  for (int y = maze.size().height - 1; y >= 0; --y) {
    for (int x = 0; x < maze.size().width; ++x) content += "0123456789abcdef"[~open_sides(maze, {x, y}) & all_sides];
    content += '\n';
  }
  return {std::move(content), {}};
}

}  // namespace

constinit const Format hex_format = {
    .name = "hex",
    .summary = "rows of hexadecimal digits, one for each cell",
    .extension = ".hex",
    .recognises = is_hex_rows,
    .read = read_hex_rows,
    .write = write_hex_rows,
};

}  // namespace labmouse
