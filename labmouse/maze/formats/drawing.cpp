// The text drawing common among micromouse builders: posts `o` or `+`, walls `---` and `|`, start `S`, goals `G`.
//
//     o---o---o   line 1: the north sides of the row y = 1
//     |     G |   line 2: its cells, each with the wall west of it
//     o   o---o   line 3: the north sides of the row y = 0
//     | S     |
//     o---o---o   last line: the south sides of the row y = 0, stored as the north sides of y = -1
#include "labmouse/maze/formats/drawing_reader.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse {
namespace {

using namespace formats;

bool is_drawing(std::string_view content) {
  const std::string line = with_plain_dots(first_line(content));
  return !line.empty() && is_post(line.front()) && line.find_first_not_of("o+- .:") == std::string_view::npos;
}

// Which marks are drawn. A cell has room for one letter. If the start is a goal, one mark is left out; it must be one
// that a reader sets by default.
struct Marks {
  bool start = true;
  bool goals = true;
};

std::optional<Marks> marks_of(const Maze& maze) {
  if (!maze.is_goal(maze.start())) return Marks{};
  if (maze.start() == Cell{0, 0}) return Marks{.start = false};
  if (maze.goals() == centre_of(maze.size())) return Marks{.goals = false};
  return std::nullopt;
}

std::string wall_line(const PartialMap& map, int y) {
  std::string line = "o";
  for (int x = 0; x < map.known.size().width; ++x) {
    const Wall wall{{x, y}, Heading::north};
    const bool unseen = map.unseen.contains(wall);
    line += unseen ? "...o" : map.known.open_walls().contains(wall) ? "   o" : "---o";
  }
  return line + '\n';
}

std::string cell_line(const PartialMap& map, int y, Marks marks) {
  std::string line;
  for (int x = 0; x < map.known.size().width; ++x) {
    const Cell cell{x, y};
    const bool unseen = map.unseen.contains(wall_at(cell, Heading::west));
    line += unseen ? ": " : map.known.is_open(cell, Heading::west) ? "  " : "| ";
    const bool start = marks.start && cell == map.known.start();
    const bool goal = marks.goals && map.known.is_goal(cell);
    line += start ? "S " : goal ? "G " : "  ";
  }
  return line + "|\n";
}

WriteResult write_drawing(const Maze& maze) { return write_partial_map({maze, {}}); }

}  // namespace

constinit const Format drawing_format = {
    .name = "drawing",
    .summary = "posts, walls, S and G as text",
    .extension = ".txt",
    .recognises = is_drawing,
    .read = read_drawing,
    .write = write_drawing,
};

WriteResult write_partial_map(const PartialMap& map) {
  const Maze& maze = map.known;
  if (maze.start_heading() != Heading::north)
    return {std::nullopt, "the start heading is " + std::string(labmouse::name_of(maze.start_heading())) +
                              "; a drawing always starts heading north"};
  const auto marks = marks_of(maze);
  if (!marks) return {std::nullopt, "the start is also a goal; a drawing has room for only one letter in a cell"};
  std::string content;
  for (int y = maze.size().height - 1; y >= 0; --y) content += wall_line(map, y) + cell_line(map, y, *marks);
  return {content + wall_line(map, -1), {}};
}

}  // namespace labmouse
