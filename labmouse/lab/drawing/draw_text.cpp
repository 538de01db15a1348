// Mazes for terminals. Each cell is a box of 5×3 characters that shares its edges with its neighbours:
//
//      o---o      o- -o      o   o
//      |G12|      : ^ :        . .     known walls, unknown walls, a route that turns
//      o---o      o- -o      o . o
#include <fmt/format.h>

#include <set>
#include <string>
#include <utility>

#include "labmouse/lab/drawing/canvas.hpp"
#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/drawing/heat.hpp"
#include "labmouse/lab/drawing/legs.hpp"
#include "labmouse/lab/drawing/walls.hpp"
#include "labmouse/lab/drawing/words.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using namespace drawing;

constexpr std::size_t cell_columns = 3;

/// The text in the middle of a cell's three columns. A longer text ends in `~`, so that a cut number does not look like
/// another number.
std::u32string centred(std::u32string text) {
  if (text.size() > cell_columns) return text.substr(0, cell_columns - 1) + U"~";
  if (text.size() < cell_columns) text.insert(0, 1, U' ');
  text.resize(cell_columns, U' ');
  return text;
}

struct WallSigns {
  std::u32string_view north, east;
  Ink ink;
};

WallSigns signs_of(WallLook look) {
  if (look == WallLook::unknown) return {U"- -", U":", Ink::dim};
  if (look == WallLook::guessed_open) return {U"###", U"#", Ink::wrong};
  if (look == WallLook::guessed_closed) return {U"%%%", U"%", Ink::to_goal};
  return {U"---", U"|", Ink::plain};
}

class TextDrawing {
 public:
  TextDrawing(const Maze& maze, const DrawingLayers& layers)
      : maze_(maze),
        layers_(layers),
        margin_(layers.coordinates ? 3 : 0),
        canvas_(margin_ + 4 * maze.size().width + 1, 2 * maze.size().height + 1 + (layers.coordinates ? 1 : 0)) {}

  std::string draw(bool colours) {
    draw_heat();
    draw_paint();
    for_each_wall(maze_.size(), [&](Wall wall) { draw_wall(wall); });
    draw_search_run();
    const auto legs = legs_of(maze_, layers_.route);
    for (const Leg& leg : legs) draw_trail(leg);
    for (std::size_t step = 0; step < legs.size(); ++step) write(legs[step].to, std::to_string(step + 1), Ink::route);
    draw_labels();
    if (layers_.mouse) draw_mouse(*layers_.mouse);
    draw_mark(maze_.start(), U"S", Ink::start);
    maze_.goals().for_each([&](Cell cell) { draw_mark(cell, U"G", Ink::goal); });
    if (layers_.coordinates) draw_coordinates();
    const std::string title = utf8(printable(layers_.title));
    return (title.empty() ? "" : title + '\n') + canvas_.text(colours) + key();
  }

 private:
  /// Column and row of the middle of a cell.
  int column(Cell cell) const { return margin_ + 4 * cell.x + 2; }
  int row(Cell cell) const { return 2 * (maze_.size().height - cell.y) - 1; }

  void write(Cell cell, const std::string& text, Ink ink) {
    canvas_.put(column(cell) - 1, row(cell), centred(printable(text)), ink);
  }

  void draw_heat() {
    const Heat heat(maze_.size(), layers_.visits);
    CellSet::all(maze_.size()).for_each([&](Cell cell) {
      canvas_.warm(column(cell) - 1, row(cell), static_cast<int>(cell_columns), heat.level(cell));
    });
  }

  void draw_paint() {
    if (!layers_.paint) return;
    CellSet::all(maze_.size()).for_each([&](Cell cell) {
      canvas_.paint(column(cell) - 1, row(cell), static_cast<int>(cell_columns), layers_.paint(cell));
    });
  }

  void draw_wall(Wall wall) {
    const WallLook look = look_of(maze_, layers_, wall);
    const bool north = wall.side == Heading::north;
    const int post_row = row(wall.cell) - 1;
    canvas_.put(column(wall.cell) + 2, post_row, U"o");
    if (north) canvas_.put(column(wall.cell) - 2, post_row, U"o");
    if (!north) canvas_.put(column(wall.cell) + 2, post_row + 2, U"o");
    if (look == WallLook::open) return;
    const WallSigns signs = signs_of(look);
    if (north) canvas_.put(column(wall.cell) - 1, post_row, signs.north, signs.ink);
    if (!north) canvas_.put(column(wall.cell) + 2, post_row + 1, signs.east, signs.ink);
  }

  /// Signs in the cells that a leg of the search run passes and in the gaps between them.
  void draw_search_run() {
    if (!layers_.search_run) return;
    const auto first = places_of(layers_.search_run->to_goal);
    const auto second = places_of(layers_.search_run->onwards);
    for (const auto& [row, column] : first) canvas_.put(column, row, U"+", Ink::to_goal);
    for (const auto& [row, column] : second) {
      const bool both = first.count({row, column}) > 0;
      canvas_.put(column, row, both ? U"*" : U"x", both ? Ink::to_goal : Ink::onwards);
    }
  }

  /// The rows and columns of the middles of cells and gaps that a walk passes.
  std::set<std::pair<int, int>> places_of(const std::vector<Pose>& walk) const {
    std::set<std::pair<int, int>> places;
    for (const Leg& leg : legs_of(maze_, walk)) {
      for (int half = 0; half <= 2 * leg.length; ++half) {
        const Cell cell = leg.length == 0 ? leg.from : neighbour(leg.from, *leg.direction, half / 2);
        const Cell next = half % 2 == 0 ? cell : neighbour(cell, *leg.direction);
        places.insert({(row(cell) + row(next)) / 2, (column(cell) + column(next)) / 2});
      }
    }
    return places;
  }

  /// Explains the signs of optional layers, and gives the shares of the explored cells: one line each.
  std::string key() const {
    std::string lines;
    if (const auto& search_run = layers_.search_run) {
      lines += "+ " + to_goal_words(*search_run);
      if (search_run->onwards.size() > 1) lines += ", x " + onwards_words(*search_run) + ", * both";
      lines += '\n';
    }
    if (layers_.wrong) lines += "# " + wrong_words(layers_) + '\n';
    if (layers_.false_walls) lines += "% " + false_words(*layers_.false_walls) + '\n';
    if (layers_.explored) lines += visited_words(*layers_.explored) + ", " + discovered_words(*layers_.explored) + '\n';
    return lines;
  }

  /// Dots in the cells of a leg and in the gaps between them.
  void draw_trail(const Leg& leg) {
    for (int gone = 0; gone < leg.length; ++gone) {
      const Cell cell = neighbour(leg.from, *leg.direction, gone);
      const Cell next = neighbour(cell, *leg.direction);
      if (gone > 0) write(cell, ".", Ink::route);
      canvas_.put((column(cell) + column(next)) / 2, (row(cell) + row(next)) / 2, U".", Ink::route);
    }
  }

  void draw_labels() {
    if (!layers_.label) return;
    CellSet passed;
    for (const Pose& pose : layers_.route) passed.insert(pose.cell);
    CellSet::all(maze_.size()).for_each([&](Cell cell) {
      const std::string label = layers_.label(cell);
      if (!label.empty()) write(cell, label, passed.contains(cell) ? Ink::route : Ink::plain);
    });
  }

  void draw_mouse(Pose pose) {
    constexpr std::string_view shapes = "^>v<";
    write(pose.cell, std::string(1, shapes[static_cast<std::size_t>(pose.heading)]), Ink::mouse);
  }

  /// The letter of a start or goal cell: in the middle, else left of what is there if that place is blank.
  void draw_mark(Cell cell, std::u32string_view letter, Ink ink) {
    const int front = column(cell) - 1;
    if (canvas_.blank(front + 1, row(cell))) return canvas_.put(front + 1, row(cell), letter, ink);
    if (canvas_.blank(front, row(cell))) canvas_.put(front, row(cell), letter, ink);
  }

  void draw_coordinates() {
    const Size size = maze_.size();
    for (int y = 0; y < size.height; ++y) canvas_.put(0, row({0, y}), printable(fmt::format("{:2}", y)), Ink::dim);
    for (int x = 0; x < size.width; ++x)
      canvas_.put(column({x, 0}) - 1, 2 * size.height + 1, centred(printable(std::to_string(x))), Ink::dim);
  }

  const Maze& maze_;
  const DrawingLayers& layers_;
  int margin_;
  Canvas canvas_;
};

}  // namespace

std::string draw_text(const Maze& maze, const DrawingLayers& layers, bool colours) {
  return TextDrawing(maze, layers).draw(colours);
}

TextDrawer text_drawer(bool colours) {
  return [colours](const Maze& maze, const DrawingLayers& layers) { return draw_text(maze, layers, colours); };
}

}  // namespace labmouse
