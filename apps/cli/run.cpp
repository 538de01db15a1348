// labmouse run: one contest.
#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "explain.hpp"
#include "guests.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/steps/steps_files.hpp"
#include "walk.hpp"

namespace labmouse::cli {
namespace {

struct RunOptions {
  std::string mouse, maze, svg, record;
  Places places;
  Rules rules;
  ExplainOptions explain;
  GuestOptions guests;
  std::uint64_t seed = 1;
  bool watch = false;
  int delay = 60;
};

void run_contest(const RunOptions& options) {
  expect_outputs({{"--record", options.record}, {"--svg", options.svg}});
  const std::vector<Contestant> mice = find_contestants({options.mouse}, options.guests);
  if (mice.size() != 1) throw UsageError("error: `labmouse run` takes one mouse; to run several, use `labmouse race`");
  const Contestant& mouse = mice.front();
  const char* const hint = mouse.make      ? ""
                           : mouse.program ? "; use `labmouse mms` or `labmouse race`"
                                           : "; use `labmouse race`";
  if (const std::string reason = refuse_to_walk(mouse); !reason.empty()) throw UsageError("error: " + reason + hint);
  const NamedMaze maze = find_maze(options.maze, options.places);
  for (const std::string& file : {options.maze, options.record, options.svg}) options.guests.hidden->add(file);
  const Rules& rules = options.rules;
  const auto mind = mouse.make(maze.maze, rules, options.seed);
  if (options.explain.wanted) mind->keep_reasons();
  const RecordFile file = record_file_of(mouse, maze, rules, options.seed, labmouse::run(maze.maze, rules, *mind));
  if (options.watch)
    watch(file, options.delay);
  else
    print(summary_of(file));
  print(freedom_note(mice));
  explain(file, options.explain, mouse.name + " kept no reasons.");
  if (!options.record.empty()) save(options.record, write_record(file));
  if (!options.svg.empty()) save(options.svg, picture_of(file));
}

}  // namespace

void add_run(Command& app, int& exit) {
  auto options = std::make_shared<RunOptions>();
  Command* command = app.add_subcommand("run", "Run one mouse in one maze");
  command->add_option("mouse", options->mouse, "Mouse: name[:key=value]..., capstone:FILE or guest:COMMAND")
      ->required()
      ->type_name("MOUSE");
  command->add_option("maze", options->maze, "Maze file or built-in maze")->required()->type_name("MAZE");
  add_places(*command, options->places);
  add_budget(*command, options->rules);
  command->add_option("--seed", options->seed, "Seed for a mouse that throws dice")
      ->check(seed_number())
      ->capture_default_str();
  add_explain(*command, options->explain);
  command->add_flag("--watch", options->watch, "Draw every step");
  command->add_option("--delay", options->delay, "Milliseconds to show each step")
      ->check(in_range(0, 60'000))
      ->capture_default_str();
  command->add_option("--svg", options->svg, "Save a picture")->type_name("FILE");
  command->add_option("--record", options->record, "Save the record; with --explain, include the reasons")
      ->type_name("FILE");
  add_python(*command, options->guests);
  add_guest_options(*command, options->guests);
  command->footer("Example: labmouse run certify capstone-1 --watch --svg walk.svg");
  command->callback([options, &exit] {
    run_contest(*options);
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
