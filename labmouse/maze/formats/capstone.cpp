// The format of the "Plot and Navigate a Virtual Maze" capstone: a size, then a line of numbers for each column.
//
// The file shows the maze on its side: the first line of numbers is the column x = 0, and its first number is y = 0.
// A number adds up the open sides: 1 north, 2 east, 4 south, 8 west, the same bits as Sides.
#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse {
namespace {

using namespace formats;

constexpr std::size_t most_lines_of_capstone = 1 + max_side;

// The first line is one number, the size; the second line has commas if the maze has more than one cell. A single line
// with commas is accepted, too, so that the reader can report the missing size.
bool is_capstone(std::string_view content) {
  const std::vector<Line> lines = lines_of(content, 2);
  if (lines.empty() || !has_only_numbers(lines[0].text)) return false;
  if (lines[0].text.find(',') != std::string_view::npos) return lines.size() == 1;
  if (words_between_blanks(lines[0].text, 2).size() != 1) return false;
  return lines.size() == 1 || lines[1].text.size() != lines[0].text.size() || number_of(lines[0].text, 1, 1);
}

std::string column_name(int x) { return "column x=" + std::to_string(x); }

// Reads the line of column x, from the south.
void read_column(const Line& line, int x, int side, std::vector<CellStatement>& statements, ProblemList& problems) {
  const auto words = words_between_commas(line.text, static_cast<std::size_t>(side) + 1);
  for (int y = 0; y < static_cast<int>(words.size()); ++y) {
    const Word& word = words[static_cast<unsigned>(y)];
    if (y == side) {
      problems.add(line.number, word.column, column_name(x) + " has more than " + std::to_string(side) + " numbers");
    } else if (const auto open = number_of(word.text, 0, all_sides)) {
      statements.push_back({{x, y}, static_cast<Sides>(*open), line.number, word.column});
    } else {
      problems.add(line.number, word.column, "expected a number from 0 to 15, found " + quoted(word.text));
    }
  }
  if (static_cast<int>(words.size()) < side)
    problems.add(
        line.number, line.end(),
        column_name(x) + " has " + std::to_string(words.size()) + " numbers, expected " + std::to_string(side));
}

ReadResult read_columns(const std::vector<Line>& lines, int side) {
  std::vector<CellStatement> statements;
  ProblemList problems;
  const int columns = static_cast<int>(lines.size()) - 1;
  for (int x = 0; x < columns && x < side && !problems.full(); ++x)
    read_column(lines[static_cast<unsigned>(x) + 1], x, side, statements, problems);
  if (columns < side)
    problems.add(lines.back().number + 1, 1,
                 "expected " + std::to_string(side) + " lines of numbers, found " + std::to_string(columns));
  if (columns > side)
    problems.add(side + 2, 1, "expected only " + std::to_string(side) + " lines of numbers, found one more");
  if (!problems.empty()) return problems.failure();
  return maze_of({side, side}, statements);
}

ReadResult read_capstone(std::string_view content) {
  const auto lines = lines_of(content, most_lines_of_capstone + 1);
  if (lines.empty()) return failure(0, 0, "the file is empty");
  const auto words = words_between_blanks(lines.front().text, 1);
  const int column = words.empty() ? 1 : words.front().column;
  const std::string_view size = lines.front().text.substr(static_cast<unsigned>(column) - 1);
  const auto side = number_of(size, 1, max_side);
  if (!side) return failure(1, column, "expected the size, a number from 1 to 64, found " + quoted(size));
  return read_columns(lines, *side);
}

WriteResult write_capstone(const Maze& maze) {
  const auto [width, height] = maze.size();
  if (width != height) return {std::nullopt, "the maze is not square; the capstone format holds only square mazes"};
  if (std::string reason = refused_marks(maze); !reason.empty()) return {std::nullopt, std::move(reason)};
  std::string content = std::to_string(width) + '\n';
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < height; ++y)
      content += std::to_string(open_sides(maze, {x, y})) + (y + 1 < height ? ',' : '\n');
  return {std::move(content), {}};
}

}  // namespace

constinit const Format capstone_format = {
    .name = "capstone",
    .summary = "a size, then one line of numbers 0 to 15 for each column",
    .extension = ".txt",
    .recognises = is_capstone,
    .read = read_capstone,
    .write = write_capstone,
};

}  // namespace labmouse
