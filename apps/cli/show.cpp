// labmouse show: a maze with its distances and its best route.
#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "labmouse/lab/bounds.hpp"
#include "labmouse/lab/drawing.hpp"
#include "labmouse/mouse/distance.hpp"

namespace labmouse::cli {
namespace {

struct ShowOptions {
  std::string maze, svg;
  Places places;
  bool distances = false, no_route = false, no_coordinates = false;
};

void add_distances(const Maze& maze, const Rules& rules, DrawingLayers& layers) {
  const auto field = std::make_shared<DistanceField>(maze.size(), strides(rules.stride));
  field->fill(maze.open_walls(), maze.goals());
  layers.label = [field](Cell cell) { return field->reaches(cell) ? fmt::format("{}", field->at(cell)) : std::string(); };
  layers.label_meaning = "steps to the goal";
}

void add_route(const Maze& maze, const Rules& rules, DrawingLayers& layers) {
  Pose pose{maze.start(), maze.start_heading()};
  layers.route.push_back(pose);
  for (const Action& action : shortest_run(maze, rules)) layers.route.push_back(pose = after(pose, action));
}

void show(const ShowOptions& options) {
  const NamedMaze maze = find_maze(options.maze, options.places);
  const Rules rules;
  const Bound bound = bound_of(maze.maze, rules);
  DrawingLayers layers;
  layers.coordinates = !options.no_coordinates;
  layers.title = bound.score ? fmt::format("{}: shortest run {} steps, bound {:.3f}", maze.name, *bound.optimum, *bound.score)
                             : fmt::format("{}: the goal cannot be reached", maze.name);
  if (options.distances) add_distances(maze.maze, rules, layers);
  if (!options.no_route) add_route(maze.maze, rules, layers);
  if (options.svg.empty())
    print(draw_text(maze.maze, layers, colours()));
  else
    save(options.svg, draw_svg(maze.maze, layers));
}

}  // namespace

void add_show(CLI::App& app, int& exit) {
  auto options = std::make_shared<ShowOptions>();
  CLI::App* command = app.add_subcommand("show", "Draw a maze with its best route");
  command->add_option("maze", options->maze, "Maze file or name of a built-in maze")->required()->type_name("MAZE");
  add_places(*command, options->places);
  command->add_option("--svg", options->svg, "Save a picture in place of drawing in the terminal")->type_name("FILE");
  command->add_flag("--distances", options->distances, "Steps from each cell to the goal");
  command->add_flag("--no-route", options->no_route, "Leave the best route out");
  command->add_flag("--no-coordinates", options->no_coordinates, "Leave the coordinates out");
  command->footer("Example: labmouse show capstone-1 --distances --svg maze.svg");
  command->callback([options, &exit] {
    show(*options);
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
