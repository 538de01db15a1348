// The log of a mouse: a line for each step with its cell, its heading and the walls on its left, in front and on its
// right.
//
//     0 0 N 101
//     Step 1: Pos=[0, 1] Facing=N Walls=001 Move=100
//
// Walls of which no line speaks are unseen. The maze is the smallest square with all cells.
#include <algorithm>
#include <cctype>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse {
namespace {

using namespace formats;

constexpr std::size_t most_steps = 20'000;

/// What a line says.
struct Step {
  Cell cell;
  Heading heading = Heading::north;
  std::string_view walls;  ///< three digits, 1 is a wall
  int line = 0;
};

std::optional<Heading> heading_of(std::string_view word) {
  for (const Heading heading : all_headings) {
    const std::string_view name = labmouse::name_of(heading);
    const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
    if ((word.size() == 1 || word.size() == name.size()) && std::equal(word.begin(), word.end(), name.begin(), same))
      return heading;
  }
  return std::nullopt;
}

bool are_walls(std::string_view word) {
  return word.size() == 3 && word.find_first_not_of("01") == std::string_view::npos;
}

/// The step of a line: two numbers, a heading behind them and three digits behind that, among other words.
std::optional<Step> step_of(const Line& line) {
  std::optional<int> before, last;  // numbers
  std::optional<Heading> heading;
  std::string_view rest = line.text;
  while (!rest.empty()) {
    const auto is_word = [](char letter) { return std::isalnum(static_cast<unsigned char>(letter)) != 0; };
    const auto begin = std::find_if(rest.begin(), rest.end(), is_word);
    const auto end = std::find_if_not(begin, rest.end(), is_word);
    const std::string_view word =
        rest.substr(static_cast<std::size_t>(begin - rest.begin()), static_cast<std::size_t>(end - begin));
    rest.remove_prefix(static_cast<std::size_t>(end - rest.begin()));
    if (heading) {
      if (are_walls(word)) return Step{{*before, *last}, *heading, word, line.number};
    } else if (const auto number = number_of(word, 0, 1'000'000'000)) {
      before = last, last = number;
    } else if (before && *before < max_side && *last < max_side) {
      heading = heading_of(word);
    }
  }
  return std::nullopt;
}

/// The steps of the lines; others are skipped, such as those of names.
std::vector<Step> steps_of(std::string_view content, std::size_t most) {
  std::vector<Step> steps;
  for (const Line& line : lines_of(content, most))
    if (const auto step = step_of(line)) steps.push_back(*step);
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
  for (const Step& step : steps) side = std::max({side, step.cell.x + 1, step.cell.y + 1});
  const Size size{side, side};
  MazeDraft draft(size, MazeDraft::Inside::open);
  WallSet unseen = WallSet::all(size);
  ProblemList problems;
  for (const Step& step : steps)
    for (int i = 0; i < 3; ++i) {
      const Heading heading = turned(step.heading, i - 1);
      const bool closed = step.walls[static_cast<unsigned>(i)] == '1';
      const Wall wall = wall_at(step.cell, heading);
      if (on_border(wall, size)) {
        if (!closed) problems.add(step.line, 1, open_border(step.cell, heading));
        continue;
      }
      if (!unseen.contains(wall) && draft.is_open(step.cell, heading) == closed)
        problems.add(step.line, 1,
                     joined("cell ", name_of(step.cell), " is ", closed ? "closed" : "open", " to the ",
                            labmouse::name_of(heading), ", but an earlier line says otherwise"));
      unseen.erase(wall);
      if (closed) draft.close(step.cell, heading);
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
