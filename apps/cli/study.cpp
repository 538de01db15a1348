// labmouse study: compares mice by cross-validation; each maze is held out once.
#include "labmouse/lab/studies/study.hpp"

#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "external.hpp"
#include "labmouse/lab/races/never_started.hpp"

namespace labmouse::cli {
namespace {

struct StudyOptions {
  std::vector<std::string> mice, mice_files;
  Contests contests;
  ExternalOptions external_mice;
  int folds = StudyOrder().folds;
  bool no_learning = false;
  std::string svg, csv;
  std::string format = "table";
};

Study hold(const StudyOptions& options, const std::vector<Contestant>& mice, const RaceOrder& order,
           std::vector<NamedMaze> mazes) {
  Progress progress;
  const Interruptible interruptible;
  StudyHooks hooks;
  hooks.stop = &interruptible.stopped();
  hooks.finished = [&](std::size_t all) { progress.advance(all); };
  return hold_study(mice, std::move(mazes), {order, options.folds, !options.no_learning}, hooks);
}

int study(const StudyOptions& options) {
  if (options.mice.empty() && options.mice_files.empty()) throw UsageError("error: --mice or --mice-file is required");
  expect_outputs({{"--csv", options.csv, FileKind::study, true},
                  {"--svg", options.svg, FileKind::picture, true},
                  {"--store", options.contests.store_path}});
  Entry entry = options.contests.world.enter_one(find_contestants(with_mice_files(options.mice, options.mice_files),
                                                                  options.contests.world, options.external_mice));
  MazeCollection mazes = find_mazes_of(entry, options.contests);
  const RaceOrder order = options.contests.order_in(entry.world);
  const Study result = hold(options, entry.mice, order, std::move(mazes.mazes));
  if (!result.error.empty()) throw UsageError("error: " + result.error);
  print(options.format == "json" ? json_of(result, mazes.skipped) : table_of(result, colours()));
  options.contests.finish_store(options.format == "table");
  tell(freedom_note(entry.mice));
  const bool any = result.folds_done > 0;
  const auto save_all = result.race.stopped ? save_partial : save;
  if (any && !options.csv.empty()) save_all(options.csv, csv_of(result));
  if (any && !options.svg.empty()) save_all(options.svg, picture_of(result));
  if (result.race.stopped) return exit_interrupted();
  const std::string never_started = never_started_lines(result.race);
  tell(never_started);
  return never_started.empty() ? exit_good : exit_finding;
}

}  // namespace

void add_study(Command& app, int& exit) {
  auto options = std::make_shared<StudyOptions>();
  Command* command = app.add_subcommand("study", "Compare mice in pairs on mazes they have not learned from");
  command->group(groups::mice);
  command
      ->add_option(
          "--mice", options->mice,
          "Mice: [NAME=]mouse[:key=value]..., separated by commas, or [NAME=]capstone:FILE, program:COMMAND, "
          "controller:COMMAND, firmware:FILE, mms:COMMAND, mouse:parts=COMMAND (repeatable); the first is the one that "
          "others are compared with")
      ->type_name("SPEC")
      ->expected(1)
      ->take_all();
  add_mice_files(*command, options->mice_files);
  add_contests(*command, options->contests);
  add_racing_options(*command, options->external_mice);
  command->group("Study");
  command->add_option("--folds", options->folds, "Number of parts to divide the mazes into; each is held out once")
      ->check(in_range(2, 1'000'000))
      ->capture_default_str();
  command->add_flag("--no-learning", options->no_learning,
                    "Do not teach mice that learn; race them with what they already know");
  command->group(groups::output);
  command->add_option("--csv", options->csv, "Save the scores as CSV, one line per maze")->type_name("FILE");
  command->add_option("--svg", options->svg, "Save a picture of the differences and scores")->type_name("FILE");
  command->add_option("--format", options->format, "What is printed")
      ->check(one_of({"table", "json"}))
      ->capture_default_str();
  command->footer(
      "Example: labmouse study --mice flood,certify --mazes contest-01 contest-02 contest-03 --folds 3 --svg "
      "study.svg");
  command->refer({groups::mazes, groups::world, groups::contests, groups::programs}, "labmouse race");
  command->callback([options, &exit] { exit = study(*options); });
}

}  // namespace labmouse::cli
