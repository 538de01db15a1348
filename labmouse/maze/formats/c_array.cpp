// C arrays: a number for each cell, column by column from the south-west. A number is the sum of the walls 1 north,
// 2 east, 4 south and 8 west. Arrays of four flags, of strings and those of other languages are read as well.
//
//     const unsigned char maze[2][2] = {
//         {0x0E, 0x09},
//         {0x0C, 0x03},
//     };
#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/listed_cells.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse {
namespace {

using namespace formats;

bool is_c_array(std::string_view content) {
  if (is_json_text(content)) return false;
  const std::size_t list = content.find_first_of("{[(");
  return list != std::string_view::npos && content.find_first_of("}])", list) != std::string_view::npos;
}

ReadResult read_c_array(std::string_view content) {
  return read_listed_cells(content, "array", Layout::columns_from_west);
}

WriteResult write_c_array(const Maze& maze) {
  if (std::string reason = refused_table(maze); !reason.empty()) return {std::nullopt, std::move(reason)};
  std::string content = joined("/* maze[x][y], walls: 1 north, 2 east, 4 south, 8 west */\nconst unsigned char maze[",
                               maze.size().width, "][", maze.size().height, "] = {\n");
  for (int x = 0; x < maze.size().width; ++x) {
    for (int y = 0; y < maze.size().height; ++y)
      (content += y == 0 ? "    {0x0" : ", 0x0") += "0123456789ABCDEF"[~open_sides(maze, {x, y}) & all_sides];
    content += "},\n";
  }
  return {content + "};\n", {}};
}

}  // namespace

constinit const Format c_format = {
    .name = "c",
    .summary = "array of C, a number for each cell",
    .extension = ".h",
    .recognises = is_c_array,
    .read = read_c_array,
    .write = write_c_array,
};

}  // namespace labmouse
