// The "num" format of the mms simulator: a line `x y n e s w` for each cell, in any order; 1 is a wall, 0 is open.
#include <algorithm>
#include <array>

#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse {
namespace {

using namespace formats;

constexpr std::size_t most_lines_of_num = max_side * max_side;
constexpr std::size_t words_in_line = 6;

// A line of several numbers without commas; the reader checks their count and values. Two lines of equally many numbers
// other than six are a table, and numbers of two digits are bytes.
bool is_num(std::string_view content) {
  const std::vector<Line> lines = lines_of(content, 2);
  if (lines.empty() || !has_only_numbers(lines[0].text) || lines[0].text.find(',') != std::string_view::npos)
    return false;
  const auto words = words_between_blanks(lines[0].text, max_side);
  const auto two_digits = [](const Word& word) { return word.text.size() == 2; };
  if (words.size() < 2 || std::all_of(words.begin(), words.end(), two_digits)) return false;
  return words.size() == words_in_line || lines.size() == 1 ||
         words_between_blanks(lines[1].text, max_side).size() != words.size();
}

// The lines read so far.
struct Table {
  std::vector<CellStatement> statements;
  std::array<int, max_side * max_side> line_of{};  // by cell, indexed as in the largest maze; 0: not read yet
  Size size;
  ProblemList problems;

  int& line_of_cell(Cell cell) { return line_of[static_cast<unsigned>(Size{max_side, max_side}.index(cell))]; }
};

// The number of a word, or -1 and a problem.
int read_number(const Line& line, const Word& word, int most, ProblemList& problems) {
  if (const auto number = number_of(word.text, 0, most)) return *number;
  problems.add(line.number, word.column,
               "expected a number from 0 to " + std::to_string(most) + ", found " + quoted(word.text));
  return -1;
}

void add_statement(Table& table, const CellStatement& said) {
  int& line = table.line_of_cell(said.cell);
  if (line != 0) {
    table.problems.add(said.line, said.column,
                       "cell " + name_of(said.cell) + " is already on line " + std::to_string(line));
    return;
  }
  line = said.line;
  table.statements.push_back(said);
  table.size.width = std::max(table.size.width, said.cell.x + 1);
  table.size.height = std::max(table.size.height, said.cell.y + 1);
}

void read_line(Table& table, const Line& line) {
  const auto words = words_between_blanks(line.text, words_in_line + 1);
  if (words.size() < words_in_line) {
    table.problems.add(line.number, line.end(),
                       "expected six numbers (x y n e s w), found " + std::to_string(words.size()));
    return;
  }
  if (words.size() > words_in_line) {
    table.problems.add(line.number, words.back().column, "expected only six numbers (x y n e s w), found more");
    return;
  }
  std::array<int, words_in_line> numbers{};
  bool complete = true;
  for (unsigned i = 0; i < words_in_line; ++i) {
    numbers[i] = read_number(line, words[i], i < 2 ? max_side - 1 : 1, table.problems);
    complete = complete && numbers[i] >= 0;
  }
  if (!complete) return;
  Sides open = 0;
  for (unsigned side = 0; side < 4; ++side)
    if (numbers[2 + side] == 0) open |= 1U << side;
  add_statement(table, {{numbers[0], numbers[1]}, open, line.number, words.front().column});
}

void find_missing(Table& table) {
  for (int i = 0; i < table.size.area() && !table.problems.full(); ++i) {
    const Cell cell = table.size.cell_at(i);
    if (table.line_of_cell(cell) == 0)
      table.problems.add(0, 0,
                         "cell " + name_of(cell) + " is missing in a maze of " + std::to_string(table.size.width) +
                             "x" + std::to_string(table.size.height) + " cells");
  }
}

ReadResult read_num(std::string_view content) {
  // Too many lines are not reported here: with one line more than there can be cells, some cell occurs twice.
  const auto lines = lines_of(content, most_lines_of_num + 1);
  if (lines.empty()) return failure(0, 0, "the file is empty");
  Table table;
  for (const Line& line : lines)
    if (!table.problems.full()) read_line(table, line);
  // An unreadable line leaves a gap, so missing cells are reported only if all lines were read.
  if (table.problems.empty()) find_missing(table);
  if (!table.problems.empty()) return table.problems.failure();
  return maze_of(table.size, table.statements);
}

WriteResult write_num(const Maze& maze) {
  if (std::string reason = refused_marks(maze); !reason.empty()) return {std::nullopt, std::move(reason)};
  const Size size = maze.size();
  std::string content;
  for (int x = 0; x < size.width; ++x) {
    for (int y = 0; y < size.height; ++y) {
      content += std::to_string(x) + ' ' + std::to_string(y);
      for (const Heading side : all_headings) content += maze.is_open({x, y}, side) ? " 0" : " 1";
      content += '\n';
    }
  }
  return {std::move(content), {}};
}

}  // namespace

constinit const Format num_format = {
    .name = "num",
    .summary = "a line `x y n e s w` for each cell, 1 for a wall",
    .extension = ".num",
    .recognises = is_num,
    .read = read_num,
    .write = write_num,
};

}  // namespace labmouse
