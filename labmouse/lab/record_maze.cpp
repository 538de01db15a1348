#include "labmouse/lab/record_maze.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::ordered_json;

/// The drawing for human eyes: with S and G where it can hold both, which it cannot on one cell.
std::string drawing_of(const Maze& maze) {
  const WriteResult marked = drawing_format.write(maze.with_start(maze.start(), Heading::north));
  if (marked.content) return *marked.content;
  return *drawing_format.write(maze.with_start({0, 0}, Heading::north).with_goals(centre_of(maze.size()))).content;
}

}  // namespace

Json record_maze_json(const std::string& name, const Maze& maze) {
  Json goals = Json::array(), drawing = Json::array();
  maze.goals().for_each([&](Cell cell) { goals.push_back(Json{cell.x, cell.y}); });
  // A drawing cannot hold every start and heading, so start and goals stand beside it.
  std::string text = drawing_of(maze);
  for (std::size_t end; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1))
    drawing.push_back(text.substr(0, end));
  return {{"name", name},
          {"start", Json{maze.start().x, maze.start().y}},
          {"heading", name_of(maze.start_heading())},
          {"goals", std::move(goals)},
          {"drawing", std::move(drawing)}};
}

std::string record_line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace labmouse
