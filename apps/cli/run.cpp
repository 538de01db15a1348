// labmouse run: runs one contest.
#include <fmt/format.h>

#include <memory>
#include <variant>

#include "command.hpp"
#include "contests.hpp"
#include "external.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/text/last_lines.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "replay.hpp"
#include "worlds.hpp"

namespace labmouse::cli {
namespace {

struct RunOptions {
  std::string mouse, maze, svg, record, log;
  Places places;
  WorldChoice world;
  ExplainOptions explain;
  ExternalOptions external_mice;
  std::uint64_t seed = 1;
  bool watch = false;
  int delay = 60;
};

/// The last error lines of a controller program, or one with parts, that failed; drive records do not store them.
std::string last_words_of(const Race& race, const ContestResult& result) {
  const Contestant& mouse = race.mice.front();
  if ((!mouse.parts && !std::holds_alternative<ControllerProgram>(mouse.kind)) || result.score) return "";
  const Value said = figure_of(race, result, said_last);
  const auto* words = std::get_if<std::string>(&said);
  if (words == nullptr) return "";
  std::string text;
  for (const std::string& line : last_lines(*words))
    text += fmt::format("{}{}\n", text.empty() ? "" : "| ", shown(line));
  return text;
}

/// Runs the contest and shows it like a record.
int run_in(std::shared_ptr<const World> world, const RunOptions& options, const Contestant& mouse,
           const NamedMaze& maze) {
  Race race;
  race.order.world = std::move(world);
  race.mice = {mouse};
  race.mazes = {maze};
  race.facts = {race.world().facts(maze.maze)};
  ContestResult result;
  result.seed = result.told = options.seed;
  const Keep keep = {.record = true, .reasons = options.explain.wanted};
  // Once the contest is over, a signal ends the program at once.
  const ContestOutput held = [&] {
    const Interruptible interruptible;
    return race.world().hold(race, result, keep, &interruptible.stopped());
  }();
  if (!result.done) return exit_interrupted();
  if (!options.record.empty()) save(options.record, held.record);
  ReplayOptions shown_as;
  shown_as.file = "the record of this run";
  shown_as.svg = options.svg;
  shown_as.log = options.log;
  shown_as.has_parts = mouse.parts != nullptr;
  shown_as.explain = options.explain;
  shown_as.no_reasons = mouse.name + " kept no reasons.";
  shown_as.watch = options.watch;
  shown_as.delay = options.delay;
  const int exit = show_replay(shown_as, held.record);
  print(last_words_of(race, result));
  print(freedom_note(race.mice));
  return exit;
}

int run_contest(const RunOptions& options) {
  expect_outputs({{"--record", options.record, FileKind::record},
                  {"--svg", options.svg, FileKind::picture},
                  {"--log", options.log, FileKind::log}});
  if (find_mouse(options.maze) != nullptr && maze_named(options.mouse))
    throw UsageError(fmt::format("error: '{}' is a maze, and the mouse comes first: labmouse run {} {}", options.mouse,
                                 options.maze, options.mouse));
  std::vector<Contestant> mice = find_contestants({options.mouse}, options.external_mice);
  if (mice.size() != 1) throw UsageError("error: `labmouse run` takes one mouse; to run several, use `labmouse race`");
  Entry entry = options.world.enter_one(std::move(mice));
  const NamedMaze maze = find_maze(options.maze, options.places, {.closes_unseen = true});
  if (!options.log.empty() && entry.mice.front().parts)
    throw UsageError(
        "error: --log: parts of the controller are another program, so the contest cannot be run again for a log; the "
        "program can save what it reads");
  for (const std::string& file : {options.maze, options.record, options.svg, options.log})
    options.external_mice.hidden->add(file);
  if (const std::string reason = entry.world->refuse(maze.maze); !reason.empty())
    throw UsageError(fmt::format("error: {} {}", shown(maze.name), reason));
  suit_defaults(entry, {&maze, 1});
  return run_in(entry.world, options, entry.mice.front(), maze);
}

}  // namespace

void add_run(Command& app, int& exit) {
  auto options = std::make_shared<RunOptions>();
  Command* command = app.add_subcommand("run", "Run one mouse in one maze");
  command
      ->add_option(
          "mouse", options->mouse,
          "Mouse: name[:key=value]..., or in quotes capstone:FILE, program:COMMAND, mms:COMMAND, controller:COMMAND, "
          "firmware:FILE or name:parts=COMMAND")
      ->required()
      ->type_name("MOUSE");
  command->add_option("maze", options->maze, "Maze file or built-in maze")->required()->type_name("MAZE");
  add_places(*command, options->places);
  command->group(groups::world);
  options->world.add_to(*command);
  command->add_option("--seed", options->seed, "Seed of a stochastic mouse or world")
      ->check(seed_number())
      ->capture_default_str();
  command->group(groups::output);
  add_explain(*command, options->explain);
  add_watch(*command, options->watch, options->delay);
  command->add_option("--svg", options->svg, "Save a picture")->type_name("FILE");
  command->add_option("--record", options->record, "Save the record; with --explain, include the reasons")
      ->type_name("FILE");
  add_log(*command, options->log);
  add_runners(*command, options->external_mice);
  add_external_options(*command, options->external_mice);
  command->footer(
      "Example: labmouse run certify capstone-1 --watch --svg walk.svg\n"
      "         labmouse run festina contest-05 --world physical --variation bad-day --explain --svg drive.svg");
  command->callback([options, &exit] { exit = run_contest(*options); });
}

}  // namespace labmouse::cli
