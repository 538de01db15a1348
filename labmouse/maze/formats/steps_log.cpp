// The log of a mouse: a line for each step with its cell, its heading and the walls on its left, ahead and on its
// right.
//
//     0 0 N 101
//     Step 1: Pos=[0, 1] Facing=N Walls=001 Move=100
//
// Walls of which no line speaks are unseen. The maze is the smallest square with all cells.
#include <algorithm>

#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/step_line.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse {
namespace {

using namespace formats;

constexpr std::size_t most_steps = 20'000;

/// A line, and its number.
struct Step {
  StepLine said;
  int line = 0;
};

/// The steps of the lines; others are skipped, such as those of names.
std::vector<Step> steps_of(std::string_view content, std::size_t most) {
  std::vector<Step> steps;
  for (const Line& line : lines_of(content, most))
    if (const auto said = read_step_line(line.text)) steps.push_back({*said, line.number});
  return steps;
}

/// One of the first five lines must be a step.
bool is_steps_log(std::string_view content) {
  return content.size() < 10'000'000 && !steps_of(content.substr(0, 1000), 5).empty();
}

ReadResult read_steps_log(std::string_view content) {
  const std::vector<Step> steps = steps_of(content, most_steps);
  if (steps.empty())
    return failure(0, 0, "expected lines of x, y, a heading, and the walls left, front and right as 0 or 1");
  int side = 2;
  for (const Step& step : steps) side = std::max({side, step.said.cell.x + 1, step.said.cell.y + 1});
  const Size size{side, side};
  MazeDraft draft(size, MazeDraft::Inside::open);
  WallSet unseen = WallSet::all(size);
  ProblemList problems;
  for (const Step& step : steps)
    for (const Heading heading : all_headings) {
      const std::optional<bool> seen = step.said.closed[static_cast<std::size_t>(heading)];
      if (!seen) continue;
      const bool closed = *seen;
      const Cell cell = step.said.cell;
      const Wall wall = wall_at(cell, heading);
      if (on_border(wall, size)) {
        if (!closed) problems.add(step.line, 1, open_border(cell, heading));
        continue;
      }
      if (!unseen.contains(wall) && draft.is_open(cell, heading) == closed)
        problems.add(step.line, 1,
                     joined("cell ", name_of(cell), " is ", closed ? "closed" : "open", " to the ",
                            labmouse::name_of(heading), ", but an earlier line says otherwise"));
      unseen.erase(wall);
      if (closed) draft.close(cell, heading);
    }
  if (!problems.empty()) return problems.failure();
  return map_of(Maze(draft), unseen);
}

WriteResult write_steps_log(const Maze& maze) {
  if (maze.size().width != maze.size().height || maze.size().width == 1)
    return {std::nullopt, "the maze is not square; a log does not state the size"};
  if (std::string reason = refused_marks(maze); !reason.empty()) return {std::nullopt, std::move(reason)};
  std::string content;
  for (int i = 0; i < maze.size().area(); ++i) {
    const Cell cell = maze.size().cell_at(i);
    content += joined(cell.x, " ", cell.y, " N ");
    for (const Heading side : {Heading::west, Heading::north, Heading::east})
      content += maze.is_open(cell, side) ? '0' : '1';
    content += '\n';
  }
  return {std::move(content), {}};
}

}  // namespace

constinit const Format steps_format = {
    .name = "steps",
    .summary = "the log of a mouse: cell, heading and walls of each step",
    .extension = ".log",
    .recognises = is_steps_log,
    .read = read_steps_log,
    .write = write_steps_log,
};

}  // namespace labmouse
