#include "labmouse/maze/formats/coded_cells.hpp"

#include <algorithm>
#include <array>
#include <compare>

#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse::formats {
namespace {

/// The sides by the bits that stand for them, the lowest first.
using SideOrder = std::array<Heading, 4>;

/// One way to read a table.
struct Way {
  Size file;  ///< entries in a row, and rows
  Layout layout = Layout::rows_from_north;
  bool mirrored = false;  ///< the entries of a row count from the other end
  SideOrder order = {Heading::north, Heading::east, Heading::south, Heading::west};
  unsigned shift = 0;  ///< the lowest of the four bits
  bool openings = false;

  bool in_columns() const { return layout == Layout::columns_from_west || layout == Layout::columns_from_east; }
  Size size() const { return in_columns() ? Size{file.height, file.width} : file; }

  Cell cell_of(int row, int column) const {
    if (mirrored) column = file.width - 1 - column;
    switch (layout) {
      case Layout::rows_from_north:
        return {column, file.height - 1 - row};
      case Layout::rows_from_south:
        return {column, row};
      case Layout::columns_from_west:
        return {row, column};
      case Layout::columns_from_east:
        return {file.height - 1 - row, column};
    }
    return {};
  }

  Sides open_of(unsigned value) const {
    Sides open = 0;
    for (unsigned bit = 0; bit < 4; ++bit)
      if (((value >> (shift + bit) & 1U) != 0) == openings) open |= 1U << static_cast<unsigned>(order[bit]);
    return open;
  }
};

std::vector<SideOrder> all_orders() {
  std::vector<SideOrder> orders;
  SideOrder order = {Heading::north, Heading::east, Heading::south, Heading::west};
  do orders.push_back(order);
  while (std::next_permutation(order.begin(), order.end()));
  return orders;
}

/// The sizes that a table can have, with a square before others.
std::vector<Size> sizes_of(const CodedCells& cells) {
  const int count = static_cast<int>(cells.entries.size());
  std::vector<Size> sizes;
  for (int width = 2; width <= max_side; ++width)
    if (count % width == 0 && count / width >= 2 && count / width <= max_side &&
        (cells.width == 0 || cells.width == width))
      sizes.push_back({width, count / width});
  std::stable_sort(sizes.begin(), sizes.end(),
                   [](Size a, Size b) { return (a.width == a.height) > (b.width == b.height); });
  return sizes;
}

class Reading {
 public:
  explicit Reading(const CodedCells& cells) : cells_(cells) {}

  ReadResult read() {
    const std::vector<Size> sizes = sizes_of(cells_);
    if (sizes.empty())
      return failure(0, 0, joined(cells_.entries.size(), " cells are no maze of 2x2 to ", max_side, "x", max_side));
    for (const Size size : sizes) {
      if (merit_.faults == 0 && size.width != size.height && best_ && best_->file.width == best_->file.height) break;
      try_all(size);
    }
    if (!best_) return problems_of(usual(sizes.front()));
    ReadResult result = maze_of(best_->size(), statements(*best_));
    result.reading = describe(*best_);
    if (const auto others = rivals(); others > 0)
      result.notes.push_back(joined("the file does not say how it is to be read, and ", others, " other maze",
                                    others == 1 ? "" : "s", " would fit as well; read as ", result.reading));
    return result;
  }

 private:
  /// Why a way does not fit at all. Where nothing is right, the first reason is enough.
  ReadResult problems_of(const Way& way) const {
    ReadResult read = maze_of(way.size(), statements(way));
    read.repaired.reset();
    if (read.problems.size() < most_problems) return read;
    const Problem& first = read.problems.front();
    return failure(first.line, first.column,
                   joined("no order of cells and sides makes a maze of this; as ", describe(way), ", ", first.reason));
  }

  Way usual(Size size) const { return {.file = size, .layout = cells_.usual}; }

  std::vector<CellStatement> statements(const Way& way) const {
    std::vector<CellStatement> all;
    for (std::size_t i = 0; i < cells_.entries.size(); ++i) {
      const CodedCells::Entry& entry = cells_.entries[i];
      const int place = static_cast<int>(i);
      all.push_back({way.cell_of(place / way.file.width, place % way.file.width), way.open_of(entry.value), entry.line,
                     entry.column});
    }
    return all;
  }

  /// Tries the usual way, then the others in the order in which they are preferred.
  void try_all(Size size) {
    const bool coded_bits = cells_.code == CodedCells::Code::number &&
                            std::any_of(cells_.entries.begin(), cells_.entries.end(),
                                        [](const CodedCells::Entry& entry) { return entry.value > all_sides; });
    std::vector<Layout> layouts = {cells_.usual};
    for (const Layout each :
         {Layout::rows_from_north, Layout::rows_from_south, Layout::columns_from_west, Layout::columns_from_east})
      if (each != cells_.usual) layouts.push_back(each);
    const std::vector<SideOrder> orders =
        cells_.code == CodedCells::Code::letters ? std::vector{Way{}.order} : all_orders();
    for (const bool mirrored : {false, true})
      for (const Layout layout : layouts)
        for (const unsigned shift : coded_bits ? std::vector{0U, 1U, 4U} : std::vector{0U})
          for (const bool openings : {false, true})
            for (const SideOrder& order : orders)
              consider({.file = size,
                        .layout = layout,
                        .mirrored = mirrored,
                        .order = order,
                        .shift = shift,
                        .openings = openings});
  }

  void consider(const Way& way) {
    const int most = best_ ? -merit_.faults : most_faults(way.size());
    const int faults = faults_of(way, most);
    if (faults > most) return;
    ReadResult read = maze_of(way.size(), statements(way));
    const std::optional<Maze>& maze = read.maze ? read.maze : read.repaired;
    if (!maze || std::find(mazes_.begin(), mazes_.end(), *maze) != mazes_.end()) return;
    // Many files have lists of zeros, which are not mazes.
    const int openings = maze->open_walls().count();
    if (faults > 0 ? openings < way.size().area() / 2 : openings == 0 && !is_usual(way)) return;
    mazes_.push_back(*maze);
    Merit merit = merit_of(way, *maze);
    merit.faults = -faults;
    merits_.push_back(merit);
    if (best_ && !(merit > merit_)) return;
    best_ = way;
    merit_ = merit;
  }

  /// Few enough that nobody takes another list for a maze.
  static int most_faults(Size size) { return std::min(size.area() / 16, static_cast<int>(most_problems) - 1); }

  /// The number of other mazes that fit and have the usual start or the same merit as the best; 0 if the best way is
  /// the format's usual one.
  std::ptrdiff_t rivals() const {
    if (merit_.usual) return 0;
    return std::count_if(
               merits_.begin(), merits_.end(),
               [&](const Merit& each) { return each.faults == merit_.faults && (each.odd_start || each == merit_); }) -
           1;
  }

  /// Criteria by which ways are preferred, the most important first.
  struct Merit {
    int faults = 0;          ///< openings in the border and cells that contradict each other, negative
    bool usual = false;      ///< it is that of the format
    bool starts = false;     ///< the start is open to the north only, in one of the layouts that are in use
    bool clockwise = false;  ///< the sides are north, east, south and west from the lowest bit on, in such a layout
    bool odd_start = false;  ///< the start is open to the north only

    friend auto operator<=>(const Merit&, const Merit&) = default;
  };

  bool is_usual(const Way& way) const {
    return way.layout == cells_.usual && way.order == Way{}.order && !way.mirrored && !way.openings && way.shift == 0;
  }

  Merit merit_of(const Way& way, const Maze& maze) const {
    Merit merit;
    const bool in_use = !way.mirrored && way.layout != Layout::columns_from_east;
    merit.usual = is_usual(way);
    merit.clockwise = in_use && way.order == Way{}.order;
    merit.odd_start = open_sides(maze, {0, 0}) == 1U << static_cast<unsigned>(Heading::north);
    merit.starts = in_use && merit.odd_start;
    return merit;
  }

  /// The openings in the border, and the inner walls of which its cells say different things; counts to above `most`.
  int faults_of(const Way& way, int most) const {
    const Size size = way.size();
    int faults = 0;
    std::array<Sides, max_side * max_side> table;
    for (std::size_t i = 0; i < cells_.entries.size(); ++i) {
      const int place = static_cast<int>(i);
      const Cell cell = way.cell_of(place / way.file.width, place % way.file.width);
      const Sides open = way.open_of(cells_.entries[i].value);
      faults += static_cast<int>(cell.x == 0 && has_side(open, Heading::west)) +
                static_cast<int>(cell.y == 0 && has_side(open, Heading::south)) +
                static_cast<int>(cell.x == size.width - 1 && has_side(open, Heading::east)) +
                static_cast<int>(cell.y == size.height - 1 && has_side(open, Heading::north));
      if (faults > most) return faults;
      table[static_cast<unsigned>(size.index(cell))] = open;
    }
    for (int i = 0; i < size.area(); ++i) {
      const Cell cell = size.cell_at(i);
      for (const Heading side : {Heading::north, Heading::east})
        if (const Cell other = neighbour(cell, side); size.contains(other))
          if (has_side(table[static_cast<unsigned>(i)], side) !=
              has_side(table[static_cast<unsigned>(size.index(other))], opposite(side)))
            ++faults;
      if (faults > most) return faults;
    }
    return faults;
  }

  std::string describe(const Way& way) const {
    static constexpr std::array<std::string_view, 4> places = {"rows from the north", "rows from the south",
                                                               "columns from the west", "columns from the east"};
    std::string text = joined(cells_.format, ", ", way.size().width, "x", way.size().height, ", ",
                              places[static_cast<unsigned>(way.layout)]);
    if (way.mirrored) text += way.in_columns() ? ", each from the north" : ", each from the east";
    text += way.openings ? ", openings" : ", walls";
    if (cells_.code == CodedCells::Code::letters) return text;
    for (unsigned bit = 0; bit < 4; ++bit) {
      const std::string_view side = labmouse::name_of(way.order[bit]);
      if (cells_.code == CodedCells::Code::number)
        text += joined(bit == 0 ? " " : ", ", 1U << (way.shift + bit), " ", side);
      else
        text += joined(bit == 0 ? " in the order " : ", ", side);
    }
    return text;
  }

  const CodedCells& cells_;
  std::vector<Maze> mazes_;    ///< all that fit as well as the best, or nearly so
  std::vector<Merit> merits_;  ///< of each of these
  std::optional<Way> best_;
  Merit merit_;
};

}  // namespace

ReadResult maze_of(const CodedCells& cells) { return Reading(cells).read(); }

}  // namespace labmouse::formats
