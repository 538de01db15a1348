// labmouse show: draws a maze or a record with chosen layers.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/pictures/picture_layers.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "maps.hpp"
#include "records.hpp"

namespace labmouse::cli {
namespace {

struct ShowOptions {
  const Command* command = nullptr;
  std::string maze, against, record, record_maze, svg;
  std::vector<std::string> layers;
  Places places;
  int step = 0;  ///< 0: the whole record
  bool distances = false, no_route = false, no_coordinates = false;
};

/// The requested layers or the usual ones, changed by the flags.
LayerSet chosen_layers(const ShowOptions& options, const LayerSet& usual) {
  LayersResult result = read_layers(fmt::format("{}", fmt::join(options.layers, ",")));
  if (!options.layers.empty() && !result.error.empty()) throw UsageError("error: " + result.error);
  LayerSet layers = options.layers.empty() ? usual : std::move(result.layers);
  if (options.distances && layers.contains(Layer::cells))
    throw UsageError("error: --distances and the layer cells write in the same places; choose one");
  if (options.distances) layers.insert(Layer::distances);
  if (options.no_route) layers.erase(Layer::path);
  if (options.no_coordinates) layers.erase(Layer::coordinates);
  return layers;
}

/// Prints the requested layers that a terminal cannot draw.
void tell_left_out(const ShowOptions& options, const LayerSet& layers) {
  std::vector<std::string_view> names;
  for (const Layer layer : layers)
    if (needs_svg(layer, colours())) names.push_back(name_of(layer));
  if (options.layers.empty() || names.empty()) return;
  const bool one = names.size() == 1;
  const bool colours_help =
      std::none_of(layers.begin(), layers.end(), [](Layer layer) { return needs_svg(layer, true); });
  tell(fmt::format("not drawn here: layer{} {} need{} --svg FILE{}\n", one ? "" : "s", fmt::join(names, ", "),
                   one ? "s" : "", colours_help ? " or a terminal with colours" : ""));
}

void draw(const ShowOptions& options, const Maze& maze, const LayerSet& chosen, const DrawingLayers& layers) {
  if (!options.svg.empty()) return save(options.svg, draw_svg(maze, layers));
  tell_left_out(options, chosen);
  print(draw_text(maze, layers, colours()));
}

std::string title_of(const NamedMaze& maze, const Rules& rules) {
  const Bound bound = bound_of(maze.maze, rules);
  return bound.score ? fmt::format("{}: shortest run {} steps, bound {:.3f}", maze.name, *bound.optimum, *bound.score)
                     : fmt::format("{}: the goal cannot be reached", maze.name);
}

/// The requested layers or the usual ones, for a maze without a record.
LayerSet maze_layers(const ShowOptions& options, const LayerSet& usual) {
  LayerSet chosen = chosen_layers(options, usual);
  for (const Layer layer : chosen)
    if (needs_record(layer))
      throw UsageError(fmt::format("error: layer {} needs a record; name one with --record FILE instead of the maze",
                                   name_of(layer)));
  return chosen;
}

/// Draws a map that a robot made over the true maze.
void show_map(const ShowOptions& options) {
  const LayerSet chosen = maze_layers(options, {Layer::coordinates});
  const ComparedMap map = compare_map(options.maze, options.against, options.places);
  DrawingLayers layers = layers_of(map.truth.maze, Rules(), chosen);
  layers.title = fmt::format("{}, compared with {}: of {} inner walls {} right, {} wrong, {} unseen", options.maze,
                             map.truth.name, map.walls(), map.right(), map.wrong(), map.found.unseen.count());
  layers.wrong = map.found.missed_walls;
  layers.false_walls = map.found.false_walls;
  layers.unknown = map.found.unseen;
  draw(options, map.truth.maze, chosen, layers);
}

void show_maze(const ShowOptions& options) {
  const LayerSet chosen = maze_layers(options, {Layer::path, Layer::coordinates});
  const NamedMaze maze = find_maze(options.maze, options.places, {.closes_unseen = true});
  const Rules rules;
  DrawingLayers layers = layers_of(maze.maze, rules, chosen);
  layers.title = title_of(maze, rules);
  if (!maze.unseen.empty()) layers.unknown = maze.unseen;
  draw(options, maze.maze, chosen, layers);
}

/// Removes layers for which the record has no data, and prints those that were requested.
void drop_missing(const ShowOptions& options, const RecordDrawing& drawing, LayerSet& chosen) {
  for (const auto& [layer, why] : drawing.missing)
    if (chosen.erase(layer) > 0 && !options.layers.empty())
      tell(fmt::format("not drawn: layer {}, because the record has {}\n", name_of(layer), why));
}

/// Throws UsageError where an option needs layers that this kind of record does not have.
void refuse_layers(const Command& command, const RecordKind& kind) {
  for (const char* option : {"--layer", "--step", "--distances", "--no-route", "--no-coordinates"})
    if (command.count(option) > 0) throw UsageError(fmt::format("error: {} cannot be used with {}", option, kind.name));
}

int show_record(const ShowOptions& options) {
  const std::string text = load_record_text(options.record);
  LayerSet chosen = chosen_layers(options, contest_layers());
  const auto replay = open_record(options.record, text, options.record_maze);
  if (!replay) return exit_finding;
  if (replay->layers().empty()) refuse_layers(*options.command, kind_of_record(text));
  if (replay->layers().empty() && !options.svg.empty()) {
    save(options.svg, replay->picture());
    return exit_good;
  }
  RecordDrawing drawing = replay->drawing(chosen, options.step);
  if (!drawing.error.empty()) throw UsageError("error: " + drawing.error);
  drop_missing(options, drawing, chosen);
  // On a terminal the result is printed below, as after `run` and `replay`.
  if (options.svg.empty()) drawing.layers.title.clear();
  draw(options, drawing.maze, chosen, drawing.layers);
  if (options.svg.empty()) print(drawing.line);
  return exit_good;
}

int show(const ShowOptions& options) {
  expect_outputs({{"--svg", options.svg, FileKind::picture}});
  const bool places = !options.places.start.empty() || !options.places.goals.empty();
  if (options.maze.empty() == options.record.empty())
    throw UsageError("error: `labmouse show` takes either a maze or --record FILE");
  if (!options.record.empty() && !options.against.empty())
    throw UsageError("error: --against needs a map instead of a record; --maze plays a record in another maze");
  if (!options.record.empty() && places)
    throw UsageError("error: --start and --goal cannot be used with --record; a record has its own start and goal");
  if (options.record.empty() && options.step > 0)
    throw UsageError("error: --step needs a record; name one with --record FILE");
  if (!options.record.empty()) return show_record(options);
  options.against.empty() ? show_maze(options) : show_map(options);
  return exit_good;
}

/// The list of layers for the help, one in each line.
std::string layer_lines() {
  std::string lines = "Layers:\n";
  for (const Layer layer : all_layers())
    lines +=
        fmt::format("  {:<12} {}{}\n", name_of(layer), meaning_of(layer), needs_record(layer) ? " (records only)" : "");
  return lines;
}

}  // namespace

void add_show(Command& app, int& exit) {
  auto options = std::make_shared<ShowOptions>();
  Command* command =
      app.add_subcommand("show", "Draw a maze with its best route, a map over its maze, or the layers of a record");
  options->command = command;
  command->add_option("maze", options->maze, "Maze file or built-in maze")->type_name("MAZE");
  add_places(*command, options->places);
  command
      ->add_option("--against", options->against, "Draw MAZE as a map of this maze: its false, missed and unseen walls")
      ->type_name("MAZE");
  auto* record = command->add_option("--record", options->record, "Draw this record instead of a maze");
  record->type_name("FILE");
  add_record_maze(*command, options->record_maze)->needs(record);
  command->add_option("--layer", options->layers, "Draw these layers instead of the default ones")
      ->type_name("NAME,...")
      ->expected(1)
      ->take_all();
  command->add_option("--step", options->step, "Draw the record up to this step")->check(in_range(1, 1'000'000));
  command->add_option("--svg", options->svg, "Save a picture instead of drawing in the terminal")->type_name("FILE");
  command->add_flag("--distances", options->distances, "Write the number of steps to the goal in each cell");
  command->add_flag("--no-route", options->no_route, "Omit the path");
  command->add_flag("--no-coordinates", options->no_coordinates, "Omit the coordinates");
  command->footer(
      layer_lines() +
      "\nExample: labmouse show capstone-1 --distances --svg maze.svg\n"
      "         labmouse run certify capstone-1 --record walk.jsonl && labmouse show --record walk.jsonl --layer heat");
  command->callback([options, &exit] { exit = show(*options); });
}

}  // namespace labmouse::cli
