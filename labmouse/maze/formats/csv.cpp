// CSV: a line for each cell with its row from the north, its column from the west, and the walls north, east, south and
// west; 1 is a wall. Tables of a number for each cell, with commas, semicolons, tabs or blanks, are read as well.
//
//     row;column;north;east;south;west
//     0;0;1;0;0;1
#include <algorithm>
#include <span>

#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"
#include "labmouse/maze/formats/text_rows.hpp"

namespace labmouse {
namespace {

using namespace formats;

constexpr std::size_t most_lines = max_side * max_side + 1;
constexpr unsigned most_value = 0xFFFF;

/// The numbers of a line; nothing where there is something else.
std::optional<std::vector<CodedCells::Entry>> numbers_of(const Line& line) {
  std::vector<CodedCells::Entry> numbers;
  std::size_t from = 0;
  while ((from = line.text.find_first_not_of(",; \t", from)) != std::string_view::npos) {
    const std::size_t to = std::min(line.text.find_first_of(",; \t", from), line.text.size());
    const auto number = number_of(line.text.substr(from, to - from), 0, most_value);
    if (!number || numbers.size() > 2 * max_side + 1) return std::nullopt;
    numbers.push_back({static_cast<unsigned>(*number), line.number, static_cast<int>(from) + 1});
    from = to;
  }
  return numbers;
}

struct NumberLines {
  std::vector<std::vector<CodedCells::Entry>> lines;
  bool has_places = false;  ///< row, column and four sides
};

/// Reads lines of equally many numbers; the first line may hold names instead. Other lines are problems.
NumberLines table_of(std::span<const Line> lines, ProblemList& problems) {
  NumberLines table;
  for (const Line& line : lines) {
    auto numbers = numbers_of(line);
    if (!numbers && line.number == 1) continue;
    const std::size_t expected = table.lines.empty() || !numbers ? 0 : table.lines.front().size();
    if (!numbers)
      problems.add(line.number, 1, "expected whole numbers between commas, semicolons or blanks");
    else if (numbers->empty() || (expected != 0 && numbers->size() != expected))
      problems.add(line.number, 1, joined("expected as many numbers as in the first line, found ", numbers->size()));
    else
      table.lines.push_back(std::move(*numbers));
  }
  if (table.lines.empty()) {
    problems.add(0, 0, "expected lines of numbers");
    return table;
  }
  if (table.lines.size() >= most_lines) problems.add(0, 0, "more than 4096 lines of numbers");
  table.has_places =
      table.lines.front().size() == 6 && std::all_of(table.lines.begin(), table.lines.end(), [](const auto& line) {
        return std::all_of(line.begin() + 2, line.end(), [](const CodedCells::Entry& each) { return each.value <= 1; });
      });
  return table;
}

/// Judged by the first lines; the reader finds what is wrong below.
bool is_csv(std::string_view content) {
  ProblemList problems;
  const NumberLines table = table_of(lines_of(content, 4), problems);
  return problems.empty() && table.lines.size() >= 2 && table.lines.front().size() >= 2 &&
         !capstone_format.recognises(content) && !num_format.recognises(content) && !dump_format.recognises(content);
}

/// Lines of a place and four sides.
ReadResult read_places(const NumberLines& table) {
  Size size{1, 1};
  for (const auto& line : table.lines) {
    if (line[0].value >= max_side || line[1].value >= max_side)
      return failure(line[0].line, line[0].column, "row and column must be from 0 to 63");
    size.height = std::max(size.height, static_cast<int>(line[0].value) + 1);
    size.width = std::max(size.width, static_cast<int>(line[1].value) + 1);
  }
  CodedCells cells{.format = "table of cells", .code = CodedCells::Code::flags, .width = size.width};
  cells.entries.resize(static_cast<std::size_t>(size.area()));
  for (const auto& line : table.lines) {
    CodedCells::Entry& entry = cells.entries[line[0].value * static_cast<unsigned>(size.width) + line[1].value];
    if (entry.line != 0)
      return failure(line[0].line, line[0].column, joined("this cell is already on line ", entry.line));
    entry = line[0];
    entry.value = line[2].value | line[3].value << 1U | line[4].value << 2U | line[5].value << 3U;
  }
  if (table.lines.size() != cells.entries.size())
    return failure(
        0, 0,
        joined(cells.entries.size() - table.lines.size(), " of ", size.width, "x", size.height, " cells are missing"));
  return maze_of(cells);
}

ReadResult read_csv(std::string_view content) {
  if (is_blank(content)) return failure(0, 0, "the file is empty");
  ProblemList problems;
  const NumberLines table = table_of(lines_of(content, most_lines + 1), problems);
  if (!problems.empty()) return problems.failure();
  if (table.has_places) return read_places(table);
  NumberTable numbers{.width = static_cast<int>(table.lines.front().size())};
  for (const auto& line : table.lines) numbers.entries.insert(numbers.entries.end(), line.begin(), line.end());
  return read_number_table(numbers, "table of numbers");
}

WriteResult write_csv(const Maze& maze) {
  if (std::string reason = refused_table(maze); !reason.empty()) return {std::nullopt, std::move(reason)};
  std::string content = "row;column;north;east;south;west\n";
  const Size size = maze.size();
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column) {
      content += joined(row, ";", column);
      for (const Heading side : all_headings)
        content += maze.is_open({column, size.height - 1 - row}, side) ? ";0" : ";1";
      content += '\n';
    }
  return {std::move(content), {}};
}

}  // namespace

constinit const Format csv_format = {
    .name = "csv",
    .summary = "a line for each cell with row, column and four walls",
    .extension = ".csv",
    .recognises = is_csv,
    .read = read_csv,
    .write = write_csv,
};

}  // namespace labmouse
