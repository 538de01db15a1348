#include "labmouse/lab/records/record_maze.hpp"

#include <fmt/format.h>

namespace labmouse {
namespace {

/// The drawing, for people. It shows S and G, except where start and goal share one cell.
std::string drawing_of(const Maze& maze) {
  const WriteResult marked = drawing_format.write(maze.with_start(maze.start(), Heading::north));
  if (marked.content) return *marked.content;
  return *drawing_format.write(maze.with_start({0, 0}, Heading::north).with_goals(centre_of(maze.size()))).content;
}

CellSet read_goals(JsonFields& fields) {
  CellSet goals;
  for (const ReadJson& goal : fields.list("goals")) goals.insert(fields.cell(goal, "goals"));
  return goals;
}

}  // namespace

Json record_maze_json(const std::string& name, const Maze& maze) {
  Json goals = Json::array(), drawing = Json::array();
  maze.goals().for_each([&](Cell cell) { goals.push_back(Json{cell.x, cell.y}); });
  // A drawing cannot show every start and heading, so start and goals are fields of their own.
  std::string text = drawing_of(maze);
  for (std::size_t end; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1))
    drawing.push_back(text.substr(0, end));
  return {{"name", name},
          {"start", Json{maze.start().x, maze.start().y}},
          {"heading", name_of(maze.start_heading())},
          {"goals", std::move(goals)},
          {"drawing", std::move(drawing)}};
}

std::optional<Maze> read_record_maze(JsonFields& fields) {
  std::string drawing;
  for (const ReadJson& row : fields.list("drawing")) {
    if (!row.is_string()) return fields.fail("has a drawing with a line that is not a string", std::nullopt);
    drawing += row.get<std::string>() + "\n";
  }
  const ReadResult read = drawing_format.read(drawing);
  if (!read.maze) {
    const Problem& first = read.problems.front();
    return fields.fail(fmt::format("has a bad drawing, row {}, column {}: {}", first.line, first.column, first.reason)),
           std::nullopt;
  }
  const Cell start = fields.has("start") ? fields.cell("start") : read.maze->start();
  const Heading heading = fields.has("heading") ? fields.heading("heading") : read.maze->start_heading();
  const CellSet goals = fields.has("goals") ? read_goals(fields) : read.maze->goals();
  CellSet outside = goals;
  outside -= CellSet::all(read.maze->size());
  if (goals.empty() || !outside.empty() || !read.maze->size().contains(start))
    fields.fail("has a start or a goal outside the maze, or no goal");
  if (!fields.error().empty()) return std::nullopt;
  return read.maze->with_goals(goals).with_start(start, heading);
}

std::string record_line(const Json& json) { return one_line(json) + "\n"; }

}  // namespace labmouse
