#include "labmouse/maze/formats/format.hpp"

#include <array>
#include <utility>

#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"
#include "labmouse/maze/symmetry.hpp"

namespace labmouse {
namespace {

// The first format that recognises a content reads it. What one format writes, no other recognises.
constexpr std::array formats_in_order = {&drawing_format, &capstone_format, &num_format,  &maz_format,
                                         &blocks_format,  &hex_format,      &dump_format, &csv_format,
                                         &steps_format,   &json_format,     &c_format};

/// The maze with x and y changed; a default start and a default goal remain.
Maze transposed(const Maze& maze) {
  const Maze mirrored = transformed(maze, {.mirrored = true, .quarters = 1});
  return maze.start() == Cell{0, 0} ? mirrored.with_start({0, 0}, maze.start_heading()) : mirrored;
}

/// The maze that starts in one gap of the border and has its goal in the other: the start is the southern one, or the
/// western one in the same row.
Maze between(const Maze& maze, BorderGap start, BorderGap goal) {
  if (maze.size().index(goal.cell) < maze.size().index(start.cell)) std::swap(start, goal);
  CellSet goals;
  goals.insert(goal.cell);
  return maze.with_start(start.cell, opposite(start.side)).with_goals(goals);
}

void repair(ReadResult& result) {
  for (const Problem& problem : result.problems)
    result.notes.push_back(problem.reason + "; the wall is taken as closed");
  result.problems.clear();
  result.maze = std::exchange(result.repaired, std::nullopt);
}

/// Makes a maze of a partial map.
void close_unseen(ReadResult& result) {
  const Maze& known = result.partial->known;
  const WallSet& unseen = result.partial->unseen;
  MazeDraft draft(known.size(), MazeDraft::Inside::closed);
  known.open_walls().for_each([&](Wall wall) {
    if (!unseen.contains(wall)) draft.open(wall.cell, wall.side);
  });
  result.maze = Maze(draft).with_start(known.start(), known.start_heading()).with_goals(known.goals());
  result.problems.clear();
  result.notes.push_back(formats::joined("a partial map: ", unseen.count(), " of ", WallSet::all(known.size()).count(),
                                         " inner walls were not seen; they are taken as closed"));
}

/// Notes the gaps, or makes them the start and the goal of a maze.
void use_gaps(ReadResult& result, bool are_places) {
  if (!are_places || !result.maze) {
    std::string sides;
    for (const auto& [cell, side] : result.gaps)
      sides += formats::joined(sides.empty() ? "" : ", ", "to the ", labmouse::name_of(side), " of ",
                               formats::name_of(cell));
    if (!sides.empty()) result.notes.push_back("the border is open " + sides + "; it is taken as closed");
  } else if (result.gaps.size() == 2) {
    result.maze = between(*result.maze, result.gaps[0], result.gaps[1]);
  } else {
    result = formats::failure(
        0, 0,
        formats::joined("the border has ", result.gaps.size(), " gaps; for the start and the goal, it must have two"));
  }
}

}  // namespace

std::span<const Format* const> all_formats() { return formats_in_order; }

const Format* find_format(std::string_view name) {
  for (const Format* format : all_formats())
    if (format->name == name) return format;
  return nullptr;
}

const Format* format_of_file(std::string_view name) {
  const std::string_view file = name.substr(name.find_last_of('/') + 1);  // npos + 1 is 0
  const std::size_t dot = file.rfind('.');
  const std::string_view extension = dot == 0 || dot == std::string_view::npos ? "" : file.substr(dot);
  if (extension.empty() || extension == ".maze") return &drawing_format;
  if (extension == ".c") return &c_format;
  for (const Format* format : all_formats())
    if (format->extension == extension) return format;
  return nullptr;
}

const Format* recognised_format(std::string_view content) {
  for (const Format* format : all_formats())
    if (format->recognises(content)) return format;
  return nullptr;
}

ReadResult read_maze(std::string_view content, const ReadChoice& choice) {
  if (formats::is_blank(content)) return formats::failure(0, 0, "the file is empty");
  const Format* format = choice.format != nullptr ? choice.format : recognised_format(content);
  if (format == nullptr) {
    std::string names;
    for (const Format* each : all_formats()) names += (names.empty() ? "" : ", ") + std::string(each->name);
    return formats::failure(0, 0, "not a maze in any known format: " + names);
  }
  ReadResult result = format->read(content);
  if (choice.repaired && result.repaired) repair(result);
  if (choice.closes_unseen && result.partial) close_unseen(result);
  const Maze* maze = result.maze ? &*result.maze : result.partial ? &result.partial->known : nullptr;
  if (maze != nullptr && result.reading.empty())
    result.reading = formats::joined(format->name, ", ", maze->size().width, "x", maze->size().height);
  if (maze == nullptr) return result;
  use_gaps(result, choice.gaps_are_places);
  if (choice.transposed && result.maze) {
    result.maze = transposed(*result.maze);
    result.reading += ", transposed";
  }
  return result;
}

}  // namespace labmouse
