#include "labmouse/lab/replays/maze_data.hpp"

#include <fmt/format.h>

#include <vector>

#include "labmouse/lab/text/json_fields.hpp"

namespace labmouse {
namespace {

unsigned bit_of(Heading side) { return 1U << static_cast<unsigned>(side); }

unsigned closed_sides(const Maze& maze, Cell cell) {
  unsigned sides = 0;
  for (const Heading side : all_headings)
    if (!maze.is_open(cell, side)) sides |= bit_of(side);
  return sides;
}

/// The closed sides of each cell, as many as the maze has cells.
std::vector<unsigned> read_walls(JsonFields& fields, Size size) {
  const ReadJson& list = fields.list("walls");
  if (list.size() != static_cast<std::size_t>(size.area()))
    fields.fail(fmt::format("has walls for {} cells instead of {}x{}", list.size(), size.width, size.height));
  std::vector<unsigned> walls;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size.area()); ++i)
    walls.push_back(i < list.size() ? static_cast<unsigned>(fields.whole(list[i], "walls", 0, 15)) : 0);
  return walls;
}

/// Opens the walls that both of their cells state as open. A wall that only one of them states as open is an error, and
/// so is an open border.
void open_walls(const std::vector<unsigned>& walls, MazeDraft& draft, JsonFields& fields) {
  const Size size = draft.size();
  const auto is_open = [&](Cell cell, Heading side) {
    return size.contains(cell) && (walls[static_cast<std::size_t>(size.index(cell))] & bit_of(side)) == 0;
  };
  for (int i = 0; i < size.area(); ++i)
    for (const Heading side : all_headings) {
      const Cell cell = size.cell_at(i);
      if (!is_open(cell, side)) continue;
      if (is_open(neighbour(cell, side), opposite(side)))
        draft.open(cell, side);
      else
        fields.fail(fmt::format("has cell ({},{}) open to the {}, where {}", int{cell.x}, int{cell.y}, name_of(side),
                                on_border(wall_at(cell, side), size) ? "the border is" : "its neighbour is closed"));
    }
}

CellSet read_goals(JsonFields& fields, Size size) {
  CellSet goals;
  for (const ReadJson& goal : fields.list("goals"))
    if (const Cell cell = fields.cell(goal, "goals"); size.contains(cell))
      goals.insert(cell);
    else
      fields.fail("has a goal outside the maze");
  if (goals.empty()) fields.fail("has no goal");
  return goals;
}

}  // namespace

Json cell_json(Cell cell) { return Json{cell.x, cell.y}; }

Json maze_data(const std::string& name, const Maze& maze) {
  Json walls = Json::array(), goals = Json::array();
  for (int i = 0; i < maze.size().area(); ++i) walls.push_back(closed_sides(maze, maze.size().cell_at(i)));
  maze.goals().for_each([&](Cell cell) { goals.push_back(cell_json(cell)); });
  return {{"name", name},
          {"width", maze.size().width},
          {"height", maze.size().height},
          {"walls", std::move(walls)},
          {"start", cell_json(maze.start())},
          {"heading", name_of(maze.start_heading())},
          {"goals", std::move(goals)}};
}

MazeDataResult read_maze_data(const ReadJson& json, const std::string& path) {
  JsonFields fields(json, path);
  const std::string name = fields.text("name");
  const Size size{fields.whole("width", 1, max_side), fields.whole("height", 1, max_side)};
  const std::vector<unsigned> walls = read_walls(fields, size);
  const Cell start = fields.cell("start");
  const Heading heading = fields.heading("heading");
  if (!size.contains(start)) fields.fail("has its start outside the maze");
  const CellSet goals = read_goals(fields, size);
  MazeDraft draft(size, MazeDraft::Inside::closed);
  open_walls(walls, draft, fields);
  if (!fields.error().empty()) return {std::nullopt, fields.error()};
  draft.set_start(start, heading);
  goals.for_each([&](Cell goal) { draft.add_goal(goal); });
  return {NamedMaze{name, Maze(draft)}, ""};
}

}  // namespace labmouse
