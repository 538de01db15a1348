// labmouse bound: the lowest possible scores, and what a mouse could have scored in hindsight.
#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/hindsight/hindsight.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse::cli {
namespace {

struct BoundOptions {
  std::vector<std::string> mazes;
  Places places;
  std::string format = "table";
  std::string mouse;  ///< for hindsight
  HindsightOrder order;
};

std::string bounds_table(const std::vector<NamedMaze>& mazes) {
  std::string text;
  for (const NamedMaze& maze : mazes) {
    const Bound bound = bound_of(maze.maze, Rules());
    text += bound.score ? fmt::format("{:>8.3f}  shortest run {:>3} steps  {}\n", *bound.score, *bound.optimum,
                                      shown(maze.name))
                        : fmt::format("{:>8}  the goal cannot be reached  {}\n", "none", shown(maze.name));
  }
  return text;
}

std::string bounds_json(const std::vector<NamedMaze>& mazes) {
  Json json = Json::array();
  for (const NamedMaze& maze : mazes) {
    const Bound bound = bound_of(maze.maze, Rules());
    json.push_back({{"name", maze.name},
                    {"optimum", bound.optimum ? Json(*bound.optimum) : Json(nullptr)},
                    {"bound", bound.score ? Json(*bound.score) : Json(nullptr)}});
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Hindsight look_back(const BoundOptions& options, const std::vector<NamedMaze>& mazes) {
  Progress progress;
  const Interruptible interruptible;
  HindsightHooks hooks;
  hooks.stop = &interruptible.stopped();
  hooks.finished = [&](std::size_t all) { progress.advance(all); };
  return labmouse::look_back(options.mouse, mazes, options.order, hooks);
}

int bound(const BoundOptions& options) {
  const bool json = options.format == "json";
  const std::vector<NamedMaze> mazes = find_mazes(options.mazes, options.places).mazes;
  if (options.mouse.empty()) {
    print(json ? bounds_json(mazes) : bounds_table(mazes));
    return exit_good;
  }
  const Hindsight hindsight = look_back(options, mazes);
  if (!hindsight.error.empty()) throw UsageError("error: " + hindsight.error);
  print(json ? json_of(hindsight) : table_of(hindsight, colours()));
  if (hindsight.stopped) return exit_interrupted();
  tell(hindsight.never_started);
  return hindsight.never_started.empty() ? exit_good : exit_finding;
}

void add_hindsight(Command& command, BoundOptions& options) {
  Option* hindsight = command
                          .add_option("--hindsight", options.mouse,
                                      "Also show this mouse's score, and what it could have scored in hindsight")
                          ->type_name("MOUSE");
  RaceOrder& race = options.order.race;
  command
      .add_option("--perturbed", options.order.others,
                  "Number of variants (or, for a stochastic mouse, seeds) to take the best of; 0 for none")
      ->check(in_range(0, 100'000))
      ->capture_default_str()
      ->needs(hindsight);
  command.add_option("--runs", race.runs, "Contests in each maze for a stochastic mouse")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str()
      ->needs(hindsight);
  command.add_option("--budget", options.order.rules.budget, "Step limit of a contest, for both runs together")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str()
      ->needs(hindsight);
  command.add_option("--seed", race.seed, "Seed for all random choices")
      ->check(seed_number())
      ->capture_default_str()
      ->needs(hindsight);
  command.add_option("--jobs", race.jobs, "Number of threads; 0 uses all processors")
      ->check(in_range(0, 1024))
      ->capture_default_str()
      ->needs(hindsight);
}

}  // namespace

void add_bound(Command& app, int& exit) {
  auto options = std::make_shared<BoundOptions>();
  Command* command =
      app.add_subcommand("bound", "Print the best possible score of each maze: that of a mouse that knows it");
  command
      ->add_option("mazes", options->mazes,
                   "Maze files, folders, patterns or built-in mazes; default: all built-in mazes")
      ->type_name("MAZE");
  add_places(*command, options->places);
  command->add_option("--format", options->format, "What is printed")
      ->check(one_of({"table", "json"}))
      ->capture_default_str();
  add_hindsight(*command, *options);
  command->footer("Example: labmouse bound capstone-1\n         labmouse bound --hindsight certify my-mazes/");
  command->callback([options, &exit] { exit = bound(*options); });
}

}  // namespace labmouse::cli
