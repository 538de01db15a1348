// Binds mazes, their files and their generators.
#include <fmt/format.h>
#include <nanobind/ndarray.h>
#include <nanobind/operators.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "bindings.hpp"
#include "errors.hpp"
#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mazes/maze_link.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

using Place = std::pair<int, int>;
/// Cells by row and column; the southernmost row comes first.
using CellFlags = nb::ndarray<nb::numpy, bool, nb::ndim<2>>;
using GivenFlags = nb::ndarray<const bool, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

/// Any object of the user as one short line, for messages.
std::string few_words_of(nb::handle value) {
  return shown(nb::cast<std::string>(nb::module_::import_("labmouse._arguments").attr("shown")(value)));
}

/// Converts an object of the user to T, or throws UserError. nanobind's own error would take several lines.
template <class T>
T given(nb::handle value, const char* name, const char* kind) {
  T found{};
  if (!nb::try_cast(value, found))
    throw UserError(fmt::format("{} must be {}, not {}", name, kind, few_words_of(value)));
  return found;
}
std::string text_in(nb::handle value, const char* name) { return given<std::string>(value, name, "a text"); }
std::filesystem::path path_in(nb::handle value) {
  return given<std::filesystem::path>(value, "path", "the path of a file or the name of a built-in maze");
}
Place place_in(nb::handle value, const char* name) { return given<Place>(value, name, "a cell (x, y)"); }
std::vector<Place> places_in(nb::handle value, const char* name) {
  return given<std::vector<Place>>(value, name, "a list of cells (x, y)");
}

Heading heading_named(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Heading heading : all_headings) {
    if (name_of(heading) == name) return heading;
    names.push_back(name_of(heading));
  }
  const auto near = nearest_name(name, names);
  throw UserError(fmt::format("unknown heading '{}'; {}", name,
                              near.empty() ? fmt::format("the headings are {}", fmt::join(names, ", "))
                                           : fmt::format("did you mean '{}'?", near)));
}

Cell cell_in(Size size, Place place, const char* what) {
  if (place.first >= 0 && place.second >= 0 && place.first < size.width && place.second < size.height)
    return {place.first, place.second};
  throw UserError(fmt::format("the {} ({},{}) is outside the maze, which is {}x{}", what, place.first, place.second,
                              size.width, size.height));
}

template <class Things>
std::string suggestion(std::string_view word, const Things& things) {
  std::vector<std::string_view> names;
  for (const auto* thing : things) names.push_back(thing->name);
  const auto near = nearest_name(word, names);
  return near.empty() ? fmt::format("expected one of {}", fmt::join(names, ", "))
                      : fmt::format("did you mean '{}'?", near);
}

/// Raises a UserWarning for each note; throws if the user made warnings errors.
void warn(const std::vector<MazeNote>& notes) {
  for (const MazeNote& note : notes)
    if (PyErr_WarnEx(PyExc_UserWarning, fmt::format("{}: {}", note.path, note.text).c_str(), 2) < 0)
      throw nb::python_error();
}

NamedMaze load(const std::filesystem::path& path) {
  const std::vector<std::string> paths = {path.string()};
  MazeCollection found = load_mazes(paths);
  if (!found.errors.empty()) throw error_of(found.errors);
  if (found.mazes.size() != 1)
    throw UserError(fmt::format("{}: error: this names {} mazes; name exactly one", paths.front(), found.mazes.size()));
  warn(found.notes);
  return std::move(found.mazes.front());
}

NamedMaze parse(nb::handle text, nb::handle given_name) {
  const std::string name = text_in(given_name, "name");
  ReadResult read = read_maze(text_in(text, "text"));
  if (!read.maze) throw error_of({{name, read.problems}});
  for (const std::string& note : read.notes) warn({{name, note}});
  return {name, *std::move(read.maze)};
}

std::vector<NamedMaze> find(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::string> names;
  for (const auto& path : paths) names.push_back(path.string());
  MazeCollection found = names.empty() ? load_builtin_mazes() : load_mazes(names);
  if (!found.errors.empty()) throw error_of(found.errors);
  warn(found.notes);
  return std::move(found.mazes);
}

NamedMaze generate(nb::handle given_kind, nb::handle size, nb::handle given_seed, nb::handle given_loops) {
  const std::string kind = text_in(given_kind, "kind");
  const auto seed = given<std::uint64_t>(given_seed, "seed", "a whole number from 0 to 18446744073709551615");
  const auto loops = given<double>(given_loops, "loops", "a share from 0 to 1");
  const Generator* generator = find_generator(kind);
  if (generator == nullptr)
    throw UserError(fmt::format("unknown kind '{}'; {}", kind, suggestion(kind, all_generators())));
  if (!(loops >= 0.0 && loops <= 1.0)) throw UserError(fmt::format("loops is a share from 0 to 1, not {}", loops));
  int side = 0;
  const auto [width, height] = nb::try_cast(size, side, false)
                                   ? Place(side, side)
                                   : given<Place>(size, "size", "a number of cells, or (width, height)");
  const GeneratorOrder order{{width, height}, seed, static_cast<int>(loops * 1000.0 + 0.5)};
  if (const auto reason = generator->refuses(order); !reason.empty()) throw UserError(std::string(reason));
  std::string name = fmt::format("{}-{}x{}-{}", kind, width, height, seed);
  if (order.loops > 0) name += fmt::format("-loops-{}", order.loops);
  return {std::move(name), generator->make(order)};
}

NamedMaze from_walls(nb::handle given_north, nb::handle given_east, nb::handle start, nb::handle heading,
                     nb::handle given_goals, nb::handle name) {
  constexpr const char* flags = "an array of bool of the shape (height, width)";
  const auto north = given<GivenFlags>(given_north, "north", flags),
             east = given<GivenFlags>(given_east, "east", flags);
  const auto goals = given_goals.is_none() ? std::vector<Place>() : places_in(given_goals, "goals");
  if (goals.empty() && !given_goals.is_none()) throw UserError("a maze needs at least one goal; None is the centre");
  const Size size{static_cast<int>(north.shape(1)), static_cast<int>(north.shape(0))};
  if (north.shape(0) != east.shape(0) || north.shape(1) != east.shape(1))
    throw UserError(fmt::format("north has the shape ({}, {}) and east ({}, {}); both must be (height, width)",
                                north.shape(0), north.shape(1), east.shape(0), east.shape(1)));
  if (north.shape(0) > max_side || north.shape(1) > max_side || !size.valid())
    throw UserError(fmt::format("walls of the shape ({}, {}) make no maze; both sides must be from 1 to {}",
                                north.shape(0), north.shape(1), max_side));
  MazeDraft draft(size, MazeDraft::Inside::closed);
  for (int index = 0; index < size.area(); ++index) {
    const Cell cell = size.cell_at(index);
    for (const Heading side : {Heading::north, Heading::east}) {
      if ((side == Heading::north ? north : east)(cell.y, cell.x)) continue;
      if (on_border(wall_at(cell, side), size))
        throw UserError(
            fmt::format("the border is open {} of the cell ({},{}); it must be closed", name_of(side), cell.x, cell.y));
      draft.open(cell, side);
    }
  }
  draft.set_start(cell_in(size, place_in(start, "start"), "start"), heading_named(text_in(heading, "heading")));
  for (const Place& goal : goals) draft.add_goal(cell_in(size, goal, "goal"));
  return {text_in(name, "name"), Maze(draft)};
}

CellFlags walls_of(const Maze& maze, Heading side) {
  const Size size = maze.size();
  auto* flags = new bool[static_cast<std::size_t>(size.area())];
  const nb::capsule owner(flags, [](void* held) noexcept { delete[] static_cast<bool*>(held); });
  for (int index = 0; index < size.area(); ++index) flags[index] = !maze.is_open(size.cell_at(index), side);
  return CellFlags(flags, {static_cast<std::size_t>(size.height), static_cast<std::size_t>(size.width)}, owner);
}

Place place_of(Cell cell) { return {cell.x, cell.y}; }

std::vector<Place> goals_of(const Maze& maze) {
  std::vector<Place> goals;
  maze.goals().for_each([&](Cell cell) { goals.push_back(place_of(cell)); });
  return goals;
}

std::string written(const NamedMaze& maze, nb::handle given_format) {
  const std::string format_name = text_in(given_format, "format");
  const Format* format = find_format(format_name);
  if (format == nullptr)
    throw UserError(fmt::format("unknown format '{}'; {}", format_name, suggestion(format_name, all_formats())));
  const WriteResult result = format->write(maze.maze);
  if (!result.content)
    throw UserError(fmt::format("the format {} cannot hold this maze: {}", format->name, result.reason));
  return *result.content;
}

void save(const NamedMaze& maze, nb::handle path, nb::handle format) {
  const std::string file = given<std::filesystem::path>(path, "path", "the path of a file").string();
  const Format* suggested = format_of_file(file);
  const nb::str chosen(std::string(suggested == nullptr ? drawing_format.name : suggested->name).c_str());
  const std::string content = written(maze, format.is_none() ? nb::handle(chosen) : format);
  if (const auto error = write_file(file, content); !error.empty())
    throw UserError(fmt::format("{}: error: {}", file, error));
}

NamedMaze with_start(const NamedMaze& maze, nb::handle start, nb::handle heading) {
  const Cell cell = cell_in(maze.maze.size(), place_in(start, "start"), "start");
  return {maze.name, maze.maze.with_start(cell, heading_named(text_in(heading, "heading")))};
}

NamedMaze with_goals(const NamedMaze& maze, nb::handle given_goals) {
  const std::vector<Place> goals = places_in(given_goals, "goals");
  CellSet cells;
  for (const auto& goal : goals) cells.insert(cell_in(maze.maze.size(), goal, "goal"));
  if (cells.empty()) throw UserError("a maze needs at least one goal");
  return {maze.name, maze.maze.with_goals(cells)};
}

/// A text of walls, start and goals: equal for equal mazes.
std::string content_of(const NamedMaze& maze) { return link_of({"", maze.maze}); }

NamedMaze from_link(const std::string& link, const std::string& name) {
  ReadLinkResult read = read_link(link);
  if (!read.maze) throw UserError(read.error);
  return {name, std::move(read.maze->maze)};
}

std::string repr_of(const NamedMaze& maze) {
  const Size size = maze.maze.size();
  return fmt::format("<labmouse.Maze '{}' {}x{}>", maze.name, size.width, size.height);
}

}  // namespace

void bind_mazes(nb::module_& module) {
  nb::class_<NamedMaze>(
      module, "Maze",
      "An immutable maze: walls, start, goals and a name.\n\n"
      "Cells are (x, y): x counts eastwards and y northwards from (0, 0), the south-west corner. Two\n"
      "mazes are equal if walls, start, heading and goals are equal; names do not count.")
      .def(
          "__init__", [](NamedMaze* self, nb::handle path) { new (self) NamedMaze(load(path_in(path))); }, "path"_a,
          nb::sig("def __init__(self, path: str | os.PathLike[str]) -> None"),
          "Reads a maze file of any format (docs/reference/maze-files.md), or takes a built-in maze by its name.\n\n"
          "Raises Error with file, line, column and reason if there is no such maze.")
      .def_static("parse", &parse, "text"_a, "name"_a = "maze",
                  nb::sig("def parse(text: str, name: str = 'maze') -> Maze"),
                  "Reads a maze from text in any format. Raises Error with line, column and reason.")
      .def_static(
          "from_walls", &from_walls, "north"_a, "east"_a, "start"_a = Place(0, 0), "heading"_a = "north",
          "goals"_a = nb::none(), "name"_a = "maze",
          nb::sig("def from_walls(north: NDArray[numpy.bool_], east: NDArray[numpy.bool_], start: tuple[int, int] "
                  "= (0, 0), heading: str = 'north', goals: Sequence[tuple[int, int]] | None = None, "
                  "name: str = 'maze') -> Maze"),
          "Makes a maze from two arrays of bool of the shape (height, width).\n\n"
          "north[y, x] says whether there is a wall north of the cell (x, y), and east[y, x] whether there is\n"
          "one east of it. The border must be closed: north[-1, :] and east[:, -1] are all True. `goals` is a\n"
          "list of cells, or None for the centre. Raises Error if this is not a valid maze.")
      .def_prop_ro(
          "name", [](const NamedMaze& maze) { return maze.name; },
          "The name in results: the path of its file, or the name of a built-in or generated maze.")
      .def_prop_ro(
          "width", [](const NamedMaze& maze) { return maze.maze.size().width; }, "Columns of cells, 1 to 64.")
      .def_prop_ro(
          "height", [](const NamedMaze& maze) { return maze.maze.size().height; }, "Rows of cells, 1 to 64.")
      .def_prop_ro(
          "start", [](const NamedMaze& maze) { return place_of(maze.maze.start()); },
          "The cell (x, y) in which a mouse starts.")
      .def_prop_ro(
          "heading", [](const NamedMaze& maze) { return std::string(name_of(maze.maze.start_heading())); },
          "The direction that the mouse faces there: 'north', 'east', 'south' or 'west'.")
      .def_prop_ro(
          "goals", [](const NamedMaze& maze) { return goals_of(maze.maze); },
          "The goal cells, row by row from the south.")
      .def_prop_ro(
          "north", [](const NamedMaze& maze) { return walls_of(maze.maze, Heading::north); }, nb::rv_policy::automatic,
          "A new array of bool of the shape (height, width): whether there is a wall north of the cell [y, x].")
      .def_prop_ro(
          "east", [](const NamedMaze& maze) { return walls_of(maze.maze, Heading::east); }, nb::rv_policy::automatic,
          "A new array of bool of the shape (height, width): whether there is a wall east of the cell [y, x].")
      .def(
          "text", &written, "format"_a = "drawing", nb::sig("def text(self, format: str = 'drawing') -> str"),
          "The maze as text in a format: 'drawing', 'capstone', 'num', 'maz', 'blocks', 'hex', 'dump', 'csv', 'steps', "
          "'json' or 'c'. Raises Error if the format cannot hold this maze.")
      .def("save", &save, "path"_a, "format"_a = nb::none(),
           nb::sig("def save(self, path: str | os.PathLike[str], format: str | None = None) -> None"),
           "Writes the maze to a file. Without a format, the extension of the path decides (.maz, .num, .hex, .csv, "
           ".log, .json, .h; a drawing for all others). Raises Error if the format cannot hold this maze or the file "
           "cannot be written.")
      .def(
          "named",
          [](const NamedMaze& maze, nb::handle name) {
            return NamedMaze{text_in(name, "name"), maze.maze};
          },
          "name"_a, nb::sig("def named(self, name: str) -> Maze"), "The same maze under another name.")
      .def("with_start", &with_start, "start"_a, "heading"_a = "north",
           nb::sig("def with_start(self, start: tuple[int, int], heading: str = 'north') -> Maze"),
           "The same maze with another start. Raises Error if that is not a cell of the maze.")
      .def("with_goals", &with_goals, "goals"_a,
           nb::sig("def with_goals(self, goals: Sequence[tuple[int, int]]) -> Maze"),
           "The same maze with other goals, at least one. Raises Error if one is not a cell of the maze.")
      .def_prop_ro(
          "svg", [](const NamedMaze& maze) { return draw_svg(maze.maze, {}); }, "The maze as an SVG picture.")
      .def("_repr_svg_", [](const NamedMaze& maze) { return draw_svg(maze.maze, {}); })
      .def("__repr__", &repr_of)
      .def("__str__", [](const NamedMaze& maze) { return draw_text(maze.maze, {}, false); })
      .def(
          "__eq__", [](const NamedMaze& a, const NamedMaze& b) { return a.maze == b.maze; }, nb::is_operator(),
          nb::sig("def __eq__(self, arg: object, /) -> bool"))
      .def("__hash__", [](const NamedMaze& maze) { return std::hash<std::string>()(content_of(maze)); })
      .def("__getstate__", [](const NamedMaze& maze) { return std::make_pair(content_of(maze), maze.name); })
      .def("__setstate__", [](NamedMaze& maze, const std::pair<std::string, std::string>& state) {
        new (&maze) NamedMaze(from_link(state.first, state.second));
      });
  module.def("generate", &generate, "kind"_a = "contest", "size"_a = 16, "seed"_a = 1, "loops"_a = 0.0,
             nb::sig("def generate(kind: str = 'contest', size: int | tuple[int, int] = 16, seed: int = 1, "
                     "loops: float = 0.0) -> Maze"),
             "Generates a maze: 'depth-first', 'prim', 'kruskal', 'wilson', 'division', 'empty' or 'contest'.\n\n"
             "`size` is a side in cells or (width, height), 1 to 64. The same seed gives the same maze everywhere.\n"
             "`loops` is the share, 0 to 1, of the remaining inner walls that is opened afterwards.\n"
             "Raises Error if the generator cannot make such a maze.");
  module.def("find_mazes", &find, "paths"_a,
             nb::sig("def find_mazes(paths: Sequence[str | os.PathLike[str]]) -> list[Maze]"));
}

}  // namespace labmouse::python
