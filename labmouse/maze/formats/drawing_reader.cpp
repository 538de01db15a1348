#include "labmouse/maze/formats/drawing_reader.hpp"

#include <algorithm>

#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse::formats {
namespace {

constexpr std::size_t most_lines_of_drawing = 2 * max_side + 1;

/// The distance of two posts in columns, at least 2; that of most drawings where there are no two.
int spacing_of(std::string_view top_line) {
  for (std::size_t i = 2; i < top_line.size(); ++i)
    if (is_post(top_line[i])) return static_cast<int>(i);
  return 4;
}

// The size of the drawing; adds a problem for an invalid width or height.
Size size_of(const std::vector<Line>& lines, int spacing, ProblemList& problems) {
  const int width = static_cast<int>(std::min(lines.front().text.size(), std::size_t{1'000'000}));
  if (width % spacing != 1 % spacing || width <= spacing || width > spacing * max_side + 1)
    problems.add(1, lines.front().end(),
                 joined("the top line has ", width, " characters; it must have ", spacing,
                        " for each of 1 to 64 cells, plus 1"));
  if (lines.size() > most_lines_of_drawing)
    problems.add(lines.back().number, 1, "too many lines; a drawing has at most 129, for 64 rows of cells");
  else if (lines.size() % 2 != 1 || lines.size() < 3)
    problems.add(lines.back().number + 1, 1,
                 "the drawing has " + std::to_string(lines.size()) + (lines.size() == 1 ? " line" : " lines") +
                     "; it must have 2 for each row of cells, plus 1");
  if (!problems.empty()) return {};
  return {width / spacing, static_cast<int>(lines.size() / 2)};
}

class DrawingReader {
 public:
  DrawingReader(Size size, int spacing) : size_(size), spacing_(spacing), draft_(size, MazeDraft::Inside::closed) {}

  ReadResult read(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
      if (problems_.full()) break;
      const int y = size_.height - (line.number + 1) / 2;
      if (line.number % 2 == 1)
        read_walls(line, y);
      else
        read_cells(line, y);
      if (line.text.size() > text_width())
        problems_.add(line.number, static_cast<int>(text_width()) + 1, "the line is longer than the top line");
    }
    if (!problems_.empty()) return problems_.failure();
    ReadResult result = map_of(Maze(draft_), unseen_);
    result.gaps = std::move(gaps_);
    return result;
  }

 private:
  std::size_t text_width() const { return static_cast<std::size_t>(spacing_ * size_.width + 1); }

  // The posts of a line and the walls between them: the north sides of the row y.
  void read_walls(const Line& line, int y) {
    if (line.text.size() < text_width()) {
      problems_.add(line.number, line.end(), "the line is shorter than the top line; a post is missing");
      return;
    }
    for (int x = 0; x <= size_.width; ++x) {
      const int column = spacing_ * x + 1;
      if (!is_post(letter(line, column))) unexpected(line, column, "expected a post (o or +)");
      if (x < size_.width) read_wall(line, column + 1, {{x, y}, Heading::north});
    }
  }

  // A wall is equal characters between two posts, usually three: `-` closed, blank open, dot or colon not seen. The
  // first one that differs is reported.
  void read_wall(const Line& line, int column, Wall wall) {
    const char first = letter(line, column);
    int wrong = column;
    if (first == '-' || first == ' ' || is_unseen(first))
      while (wrong < column + spacing_ - 1 && letter(line, wrong) == first) ++wrong;
    if (wrong < column + spacing_ - 1)
      unexpected(
          line, wrong,
          joined("expected a wall (", std::string(static_cast<std::size_t>(spacing_) - 1, '-'), ") or as many spaces"));
    else if (first == ' ')
      open(wall);
    else if (is_unseen(first))
      leave_unseen(wall);
  }

  // The cells of the row y, each with the wall west of it, which is the east side of its neighbour.
  void read_cells(const Line& line, int y) {
    for (int x = 0; x <= size_.width; ++x) {
      const int column = spacing_ * x + 1;
      const Wall wall{{x - 1, y}, Heading::east};
      if (const char side = letter(line, column); side == ' ')
        open(wall);
      else if (is_unseen(side))
        leave_unseen(wall);
      else if (side != '|')
        unexpected(line, column, "expected a wall (|) or a space");
      if (x < size_.width) read_cell(line, column + 1, {x, y});
    }
  }

  void read_cell(const Line& line, int column, Cell cell) {
    for (int i = 0; i < spacing_ - 1; ++i) {
      const bool middle = spacing_ != 4 || i == 1;
      const char mark = letter(line, column + i);
      // Programs print distances, ways and visits into cells.
      if (std::string_view(" 0123456789^v<>.").find(mark) != std::string_view::npos) continue;
      if (middle && mark == 'S')
        read_start(line, column + i, cell);
      else if ((middle && mark == 'G') || mark == '*' || mark == '@')
        draft_.add_goal(cell);
      else
        unexpected(line, column + i, "cell " + name_of(cell) + " may contain only S or G, in the middle");
    }
  }

  void read_start(const Line& line, int column, Cell cell) {
    if (start_found_)
      problems_.add(line.number, column,
                    "cell " + name_of(cell) + " is a second start; the first is " + name_of(draft_.start()));
    else
      draft_.set_start(cell);
    start_found_ = true;
  }

  void open(Wall wall) {
    if (!on_border(wall, size_)) return draft_.open(wall.cell, wall.side);
    if (size_.contains(wall.cell))
      gaps_.push_back({wall.cell, wall.side});
    else
      gaps_.push_back({neighbour(wall.cell, wall.side), opposite(wall.side)});
  }

  static bool is_unseen(char letter) { return letter == '.' || letter == ':'; }

  void leave_unseen(Wall wall) {
    if (!size_.contains(wall.cell) || on_border(wall, size_)) return;
    draft_.open(wall.cell, wall.side);
    unseen_.insert(wall);
  }

  void unexpected(const Line& line, int column, std::string rule) {
    const char found = letter(line, column);
    problems_.add(line.number, column, std::move(rule) + ", found " + quoted({&found, 1}));
  }

  // A line may lack its trailing blanks.
  static char letter(const Line& line, int column) {
    const auto at = static_cast<std::size_t>(column) - 1;
    return at < line.text.size() ? line.text[at] : ' ';
  }

  Size size_;
  int spacing_;
  MazeDraft draft_;
  bool start_found_ = false;
  WallSet unseen_;
  std::vector<BorderGap> gaps_;
  ProblemList problems_;
};

}  // namespace

bool is_post(char letter) { return letter == 'o' || letter == '+'; }

std::string with_plain_dots(std::string_view content) {
  static constexpr std::string_view middle_dot = "\xC2\xB7";
  std::string plain;
  while (!content.empty()) {
    const bool dot = content.starts_with(middle_dot);
    plain += dot ? '.' : content.front();
    content.remove_prefix(dot ? middle_dot.size() : 1);
  }
  return plain;
}

ReadResult read_drawing(std::string_view original) {
  const std::string content = with_plain_dots(original);
  const auto lines = lines_of(content, most_lines_of_drawing + 1);
  if (lines.empty()) return failure(0, 0, "the file is empty");
  ProblemList problems;
  const int spacing = spacing_of(lines.front().text);
  const Size size = size_of(lines, spacing, problems);
  if (!problems.empty()) return problems.failure();
  return DrawingReader(size, spacing).read(lines);
}

}  // namespace labmouse::formats
