// Blocks: a picture of (2W+1)x(2H+1) characters. Cells, walls and posts are one block each; `#` is a wall or a post.
//
//     #####
//     #   #
//     # # #
//     # # #
//     #####
#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/text.hpp"
#include "labmouse/maze/formats/text_rows.hpp"

namespace labmouse {
namespace {

using namespace formats;

/// Also what only begins as blocks do, so that the reader can say what is wrong.
bool is_blocks(std::string_view content) {
  const std::string_view line = first_line(content);
  return (line.size() >= 3 && line.find_first_not_of('#') == std::string_view::npos) ||
         are_blocks(text_rows_of(content));
}

ReadResult read_blocks(std::string_view content) { return read_text_rows(text_rows_of(content), "rows of characters"); }

/// Whether the block at that place, counted in blocks from the south-west, is a wall or a post.
bool is_wall(const Maze& maze, int column, int row) {
  if (column % 2 == 0 && row % 2 == 0) return true;
  const Cell cell{(column - 1) / 2, (row - 1) / 2};
  if (column % 2 == 1 && row % 2 == 1) return false;
  if (column % 2 == 1) return row == 0 || !maze.is_open(cell, Heading::north);
  return column == 0 || !maze.is_open(cell, Heading::east);
}

WriteResult write_blocks(const Maze& maze) {
  if (std::string reason = refused_marks(maze); !reason.empty()) return {std::nullopt, std::move(reason)};
  std::string content;
  for (int row = 2 * maze.size().height; row >= 0; --row) {
    for (int column = 0; column <= 2 * maze.size().width; ++column) content += is_wall(maze, column, row) ? '#' : ' ';
    content += '\n';
  }
  return {std::move(content), {}};
}

}  // namespace

constinit const Format blocks_format = {
    .name = "blocks",
    .summary = "a picture in which cells, walls and posts are one block each",
    .extension = ".txt",
    .recognises = is_blocks,
    .read = read_blocks,
    .write = write_blocks,
};

}  // namespace labmouse
