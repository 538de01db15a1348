#include "labmouse/maze/formats/listed_cells.hpp"

#include <algorithm>
#include <cctype>

#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/nested_lists.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"
#include "labmouse/maze/formats/text_rows.hpp"

namespace labmouse::formats {
namespace {

using Kind = ListItem::Kind;
using Code = CodedCells::Code;

bool all_of(const ListItem& list, bool (*is)(const ListItem&)) {
  return list.kind == Kind::list && std::all_of(list.items.begin(), list.items.end(), is);
}

bool is_number(const ListItem& item) { return item.kind == Kind::number; }
bool is_string(const ListItem& item) { return item.kind == Kind::string; }
bool is_flag(const ListItem& item) { return is_number(item) && item.number <= 1; }
bool has_key(const ListItem& item) { return !item.key.empty(); }
bool is_object(const ListItem& item) { return item.kind == Kind::list && !item.items.empty() && all_of(item, has_key); }
bool are_four_flags(const ListItem& item) {
  return item.items.size() == 4 && all_of(item, is_flag) && !is_object(item);
}

/// The sides of letters such as "NE"; nothing where one is not of n, e, s and w.
std::optional<Sides> sides_of(std::string_view letters) {
  Sides sides = 0;
  for (const char letter : letters) {
    const std::size_t side =
        std::string_view("nesw").find(static_cast<char>(std::tolower(static_cast<unsigned char>(letter))));
    if (side == std::string_view::npos) return std::nullopt;
    sides |= 1U << side;
  }
  return sides;
}

bool are_letters(const ListItem& item) { return is_string(item) && item.text.size() <= 4 && sides_of(item.text); }

/// A side by its key or name: "n", "north", "north_wall", "wallNorth".
std::optional<Heading> side_named(std::string_view name) {
  std::string low;
  for (const char letter : name)
    if (std::isalpha(static_cast<unsigned char>(letter)) != 0)
      low += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  if (const std::size_t wall = low.find("wall"); wall != std::string::npos) low.erase(wall, 4);
  for (const Heading side : all_headings)
    if (low == labmouse::name_of(side) || low == labmouse::name_of(side).substr(0, 1)) return side;
  return std::nullopt;
}

const ListItem* item_of(const ListItem& object, std::initializer_list<std::string_view> keys) {
  for (const ListItem& item : object.items)
    if (std::find(keys.begin(), keys.end(), item.key) != keys.end()) return &item;
  return nullptr;
}

const ListItem* x_of(const ListItem& object) { return item_of(object, {"x", "col", "column"}); }
const ListItem* y_of(const ListItem& object) { return item_of(object, {"y", "row"}); }
const ListItem* walls_of(const ListItem& object) {
  return item_of(object, {"walls", "wall", "sides", "value", "cell"});
}

/// What a cell says of its sides.
struct CellCode {
  Code code = Code::number;
  unsigned value = 0;
};

std::optional<CellCode> cell_of(const ListItem& item);

/// A cell as an object: its sides by name, or under a key of their own.
std::optional<CellCode> cell_of_object(const ListItem& object) {
  if (const ListItem* walls = walls_of(object)) return cell_of(*walls);
  CellCode cell{.code = Code::letters};
  int sides = 0;
  for (const ListItem& item : object.items)
    if (const auto side = side_named(item.key); side && is_number(item)) {
      ++sides;
      if (item.number != 0) cell.value |= 1U << static_cast<unsigned>(*side);
    }
  return sides == 4 ? std::optional(cell) : std::nullopt;
}

std::optional<CellCode> cell_of(const ListItem& item) {
  if (is_number(item)) return CellCode{.value = item.number};
  if (are_letters(item)) return CellCode{.code = Code::letters, .value = *sides_of(item.text)};
  if (item.kind != Kind::list) return std::nullopt;
  if (is_object(item)) return cell_of_object(item);
  CellCode cell;
  if (are_four_flags(item)) {
    cell.code = Code::flags;
    for (unsigned i = 0; i < 4; ++i) cell.value |= item.items[i].number << i;
    return cell;
  }
  cell.code = Code::letters;
  if (item.items.size() > 4) return std::nullopt;
  for (const ListItem& each : item.items) {
    const auto side = is_string(each) ? side_named(each.text) : std::nullopt;
    if (!side) return std::nullopt;
    cell.value |= 1U << static_cast<unsigned>(*side);
  }
  return cell;
}

bool is_cell(const ListItem& item) { return cell_of(item).has_value(); }

/// The list inside wrappers: an object that contains it, or a list with it as the only item.
ListItem unwrapped(ListItem list) {
  for (;;) {
    const auto longest =
        std::max_element(list.items.begin(), list.items.end(),
                         [](const ListItem& a, const ListItem& b) { return a.items.size() < b.items.size(); });
    const bool wraps = longest != list.items.end() && longest->items.size() >= 2 && !is_cell(list) &&
                       (is_object(list) || (list.items.size() == 1 && !all_of(*longest, is_number)));
    if (!wraps) return list;
    ListItem inner = std::move(*longest);
    list = std::move(inner);
  }
}

/// The strings of a list, where each item is one or a list of one.
std::optional<std::vector<TextRow>> strings_of(const ListItem& list) {
  std::vector<TextRow> rows;
  for (const ListItem& item : list.items) {
    const ListItem& inner = item.kind == Kind::list && item.items.size() == 1 ? item.items.front() : item;
    if (!is_string(inner)) return std::nullopt;
    rows.push_back({inner.text, inner.line, inner.column + 1});
  }
  return rows;
}

/// The numbers of rows of equal length.
std::optional<NumberTable> numbers_of(const ListItem& list, Layout usual) {
  NumberTable table{.usual = usual};
  for (const ListItem& row : list.items) {
    if (!all_of(row, is_number) || row.items.size() != list.items.front().items.size()) return std::nullopt;
    for (const ListItem& item : row.items) table.entries.push_back({item.number, item.line, item.column});
  }
  table.width = static_cast<int>(list.items.front().items.size());
  return table;
}

ReadResult nothing_known(const ListItem& list) {
  return failure(
      list.line, list.column,
      "this list has no cells: expected numbers of four bits, four flags, letters of sides such as \"NE\", or "
      "objects with x, y and walls");
}

/// Reads cells one by one, checking that they all are coded in the same way.
class CellList {
 public:
  CellList(std::string_view format, Layout usual) : cells_{.format = format, .usual = usual} {}

  bool add(const ListItem& item) {
    const auto cell = cell_of(item);
    const bool same = cell && (cells_.entries.empty() || cell->code == cells_.code);
    if (!same || cells_.entries.size() == max_side * max_side) {
      wrong_ = &item;
      return false;
    }
    cells_.code = cell->code;
    cells_.entries.push_back({cell->value, item.line, item.column});
    return true;
  }

  ReadResult read(int width) {
    cells_.width = width;
    return maze_of(cells_);
  }
  ReadResult failed() const { return nothing_known(*wrong_); }

 private:
  CodedCells cells_;
  const ListItem* wrong_ = nullptr;
};

/// Cells that state their places.
ReadResult read_placed(const ListItem& list, std::string_view format) {
  Size size{1, 1};
  for (const ListItem& item : list.items) {
    const ListItem *x = x_of(item), *y = y_of(item);
    if (x == nullptr || y == nullptr || !is_number(*x) || !is_number(*y) || x->number >= max_side ||
        y->number >= max_side)
      return failure(item.line, item.column, "a cell has no x and y from 0 to 63");
    size.width = std::max(size.width, static_cast<int>(x->number) + 1);
    size.height = std::max(size.height, static_cast<int>(y->number) + 1);
  }
  std::vector<const ListItem*> places(static_cast<std::size_t>(size.area()));
  for (const ListItem& item : list.items) {
    const ListItem*& place = places[y_of(item)->number * static_cast<unsigned>(size.width) + x_of(item)->number];
    if (place != nullptr) return failure(item.line, item.column, "a cell stands twice");
    place = &item;
  }
  const bool rows = y_of(list.items.front())->key == "row";
  CellList cells(format, rows ? Layout::rows_from_north : Layout::rows_from_south);
  for (const ListItem* place : places) {
    if (place == nullptr) return failure(0, 0, joined("a cell is missing in a maze of ", size.width, "x", size.height));
    if (!cells.add(*place)) return cells.failed();
  }
  return cells.read(size.width);
}

/// The first word that is neither a number nor a string, or null.
const ListItem* first_word(const ListItem& item) {
  if (item.kind == Kind::word) return &item;
  for (const ListItem& each : item.items)
    if (const ListItem* word = first_word(each)) return word;
  return nullptr;
}

NumberTable table_of(const ListItem& list, Layout usual) {
  NumberTable table{.usual = usual};
  for (const ListItem& item : list.items) table.entries.push_back({item.number, item.line, item.column});
  return table;
}

/// Rows of cells; if cells are letters, rows are from the north, and each is from the west to the east.
ReadResult read_rows(const ListItem& list, std::string_view format, Layout usual) {
  const std::size_t width = list.items.front().items.size();
  if (width == 0) return nothing_known(list);
  const bool letters = cell_of(list.items.front().items.front()).value_or(CellCode{}).code == Code::letters;
  CellList cells(format, letters ? Layout::rows_from_north : usual);
  for (const ListItem& row : list.items) {
    if (row.kind != Kind::list || row.items.size() != width)
      return failure(row.line, row.column, "this row does not have as many cells as the first one");
    for (const ListItem& item : row.items)
      if (!cells.add(item)) return cells.failed();
  }
  return cells.read(static_cast<int>(width));
}

ReadResult read_list(const ListItem& list, std::string_view format, Layout usual) {
  if (list.items.empty()) return nothing_known(list);
  if (is_object(list.items.front()) && x_of(list.items.front()) != nullptr) return read_placed(list, format);
  if (all_of(list, is_number)) return read_number_table(table_of(list, usual), format);
  if (const auto strings = strings_of(list); strings && !all_of(list, are_letters))
    return read_text_rows(*strings, format);
  if (const auto table = numbers_of(list, usual); table && !all_of(list, are_four_flags))
    return read_number_table(*table, format);
  if (!all_of(list, is_cell)) return read_rows(list, format, usual);
  CellList cells(format, is_string(list.items.front()) ? Layout::rows_from_north : usual);
  for (const ListItem& item : list.items)
    if (!cells.add(item)) return cells.failed();
  return cells.read(0);
}

}  // namespace

bool is_json_text(std::string_view content) {
  const std::string_view line = first_line(content);
  const std::size_t first = line.find_first_not_of(blanks);
  return first != std::string_view::npos && (line[first] == '[' || line[first] == '{');
}

ReadResult read_listed_cells(std::string_view content, std::string_view format, Layout usual) {
  ProblemList problems;
  int equal = 0;
  auto list = read_lists(content, problems, equal);
  if (!list) return problems.failure();
  const ListItem cells = unwrapped(std::move(*list));
  if (const ListItem* word = first_word(cells))
    return failure(word->line, word->column, "expected a whole number or a string, found " + quoted(word->text));
  ReadResult result = read_list(cells, format, usual);
  if (equal > 0)
    result.notes.push_back(joined("the file has ", equal + 1, " lists of this length; the first one is read"));
  return result;
}

}  // namespace labmouse::formats
