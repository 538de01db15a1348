// JSON: rows of cells from the north, each cell the letters of its walls.
//
//     [["NW", "NE"],
//      ["ESW", "ESW"]]

#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/listed_cells.hpp"

namespace labmouse {
namespace {

using namespace formats;

ReadResult read_json_cells(std::string_view content) {
  return read_listed_cells(content, "list", Layout::rows_from_north);
}

WriteResult write_json_cells(const Maze& maze) {
  if (std::string reason = refused_table(maze); !reason.empty()) return {std::nullopt, std::move(reason)};
  std::string content;
  for (int y = maze.size().height - 1; y >= 0; --y) {
    content += content.empty() ? "[[" : ",\n [";
    for (int x = 0; x < maze.size().width; ++x) {
      content += x == 0 ? "\"" : ", \"";
      for (const Heading side : all_headings)
        if (!maze.is_open({x, y}, side)) content += "NESW"[static_cast<unsigned>(side)];
      content += '"';
    }
    content += ']';
  }
  return {content + "]\n", {}};
}

}  // namespace

constinit const Format json_format = {
    .name = "json",
    .summary = "JSON, the letters of the walls of each cell",
    .extension = ".json",
    .recognises = is_json_text,
    .read = read_json_cells,
    .write = write_json_cells,
};

}  // namespace labmouse
