// labmouse race: many mice on many mazes, and a leaderboard.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "command.hpp"
#include "contests.hpp"
#include "external.hpp"
#include "labmouse/lab/finish_curves/finish_curves.hpp"
#include "labmouse/lab/races/never_started.hpp"
#include "labmouse/lab/result_folders/race_folder.hpp"
#include "labmouse/lab/standings/baseline.hpp"
#include "labmouse/lab/standings/junit.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/robot_comparison.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse::cli {
namespace {

struct RaceOptions {
  std::vector<std::string> mice, mice_files;
  Contests contests;
  ExternalOptions external_mice;
  std::string format = "table", columns = "usual";
  std::string out;
  bool overwrite = false;
  std::string baseline;
  double fail_above = 0.0;
  std::string junit;
  bool has_limit = false;
  int worst = 0;
  bool shares = false;
  std::string curves;
};

/// The mice of one world, and the mazes for them.
struct Field {
  Entry entry;
  std::vector<NamedMaze> mazes;
};

/// Runs the races, one world after the other, and saves what --out requests.
class Holding {
 public:
  explicit Holding(const RaceOptions& options) : options_(options) {}

  std::vector<Race> hold(std::vector<Field> fields) {
    for (const Field& field : fields) all_ += contests_of(field.entry.mice, field.mazes.size(), order_of(field));
    std::vector<Race> races;
    for (Field& field : fields) {
      folder_.reset();
      const RaceOrder order = order_of(field);
      races.push_back(hold_race(std::move(field.entry.mice), std::move(field.mazes), order, hooks()));
    }
    return races;
  }

  /// The error of writing --out, which ends the races early; or nothing.
  const std::string& failed_write() const { return failed_write_; }

 private:
  RaceOrder order_of(const Field& field) const {
    RaceOrder order = options_.contests.order_in(field.entry.world);
    order.files.insert(order.files.end(), {options_.out, options_.baseline});
    return order;
  }

  RaceHooks hooks() {
    RaceHooks hooks;
    hooks.stop = &interruptible_.stopped();
    if (!options_.out.empty()) hooks.keep = RaceFolder::keep;
    hooks.finished = [this](const Race& race, const ContestResult& contest, const ContestOutput& held) {
      progress_.advance(all_);
      if (options_.out.empty() || !failed_write_.empty()) return;
      if (!folder_) folder_.emplace(options_.out, race);
      if (failed_write_ = folder_->save(contest, held); !failed_write_.empty()) interruptible_.stop();
    };
    return hooks;
  }

  const RaceOptions& options_;
  Progress progress_;
  Interruptible interruptible_;
  std::size_t all_ = 0;
  std::optional<RaceFolder> folder_;
  std::string failed_write_;
};

void report(const RaceOptions& options, const std::vector<Race>& races, const std::vector<SkippedFile>& skipped) {
  std::string text;
  if (options.format == "json") write_json(races, skipped, print_part);
  for (const Race& race : races) {
    if (options.format == "csv") write_csv(race, print_part);
    if (options.format == "table")
      text += (text.empty() ? "" : "\n") + table_of(race, colours(), options.columns == "all");
  }
  print(text);
}

/// Saves the results in the folder of --out. Returns what went wrong, or nothing.
std::string save_results(const RaceOptions& options, const std::vector<Race>& races,
                         const std::vector<SkippedFile>& skipped) {
  if (options.out.empty()) return "";
  const std::string path = fmt::format("{}/{}", options.out, results_file_name);
  const std::string error = write_file(path, [&](const TextSink& sink) { write_json(races, skipped, sink); });
  return error.empty() ? "" : fmt::format("{}: error: {}", path, error);
}

/// Writes the file of --junit, unless the race was stopped. Returns what went wrong, or nothing.
std::string save_junit(const RaceOptions& options, const std::vector<Race>& races) {
  if (options.junit.empty() || std::any_of(races.begin(), races.end(), [](const Race& race) { return race.stopped; }))
    return "";
  const std::optional<double> limit = options.has_limit ? std::optional(options.fail_above) : std::nullopt;
  const std::string error = write_file(options.junit, junit_of(races, limit));
  return error.empty() ? "" : fmt::format("{}: error: {}", options.junit, error);
}

/// Throws UsageError for options that fit only one race or only several.
void check_races(const RaceOptions& options, const std::vector<Entry>& entries) {
  if (!options.curves.empty() &&
      std::max(options.contests.world.values("noise"), options.contests.world.values("variation")) < 2)
    throw UsageError(
        "error: --curves draws how mice do as noise or variation grows; give several, as in `labmouse race --world "
        "failures --variation 0,0.5,1,1.2 --curves FILE`");
  if (!options.curves.empty() && options.contests.world.values("noise") > 1 &&
      options.contests.world.values("variation") > 1)
    throw UsageError("error: --curves draws races that differ in one thing; give one --noise or one --variation");
  if (!options.curves.empty() && options.contests.world.values("robot") > 1)
    throw UsageError("error: --curves draws the races of one robot; give one --robot, or leave it out");
  if (!options.out.empty() && has_several_values(entries))
    throw UsageError("error: --out keeps the records of one race; give one --robot, one --noise and one --variation");
  if (options.format == "csv" && entries.size() > 1)
    throw UsageError(
        "error: --format csv can hold only one race; give one world, one --robot, one --noise and one "
        "--variation, or use --format json");
}

/// Reports races with several scales of noise or variation together; does nothing for other races.
void report_curves(const RaceOptions& options, const std::vector<Race>& races) {
  const FinishCurves curves = finish_curves(races);
  if (curves.curves.empty()) return;
  if (options.format == "table") print("\n" + table_of(curves, races.back().world()));
  if (options.curves.empty()) return;
  const Race& race = races.back();
  const std::string title = fmt::format("Contests finished: world {}, {}", race.world().traits().name,
                                        counted(race.mazes.size(), "maze", "mazes"));
  const bool stopped = std::any_of(races.begin(), races.end(), [](const Race& each) { return each.stopped; });
  (stopped ? save_partial : save)(options.curves, draw_curves(curves, title));
}

/// Prints additions to the results: below a table, else on standard error, because programs read the output.
void add(const RaceOptions& options, const std::string& text) {
  if (options.format == "table")
    print("\n" + text);
  else
    tell(text);
}

/// The baseline of each race, in the same order. Throws UsageError where the file has no results of its world.
std::vector<std::optional<Baseline>> load_baselines(const RaceOptions& options, const std::vector<Field>& fields) {
  std::vector<std::optional<Baseline>> baselines(fields.size());
  if (options.baseline.empty()) return baselines;
  const FileContent file = read_file(options.baseline, std::size_t{1} << 30U);
  if (!file.error.empty()) throw UsageError(fmt::format("{}: error: {}", options.baseline, file.error));
  refuse_other_kind(options.baseline, file.content, FileKind::results);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    ReadBaselineResult read = read_baseline(file.content, *fields[i].entry.world);
    if (!read.error.empty()) throw UsageError(describe(options.baseline, Problem{read.line, read.column, read.error}));
    baselines[i] = std::move(read.baseline);
  }
  return baselines;
}

/// Lists the mice whose mean, with failed contests at the limit, exceeds --fail-above.
std::string above_limit(const RaceOptions& options, const Race& race) {
  std::string text;
  const World& world = race.world();
  const std::string counting =
      world.traits().failure_score
          ? ""
          : fmt::format(" (failed contests at {:g} {})", world.traits().limit_score, world.traits().unit);
  for (const Standing& standing : standings_of(race)) {
    const Contestant& mouse = race.mice[standing.mouse];
    if (!mouse.reference && standing.mean_at_limit && *standing.mean_at_limit > options.fail_above)
      text += fmt::format("{} scores {:.3f}{}, above the limit of {:g}\n", shown(mouse.name), *standing.mean_at_limit,
                          counting, options.fail_above);
  }
  return text;
}

/// The mice of each world with its mazes. `skipped` gets the files that are no mazes.
std::vector<Field> fields_of(const RaceOptions& options, std::vector<Entry> entries,
                             std::vector<SkippedFile>& skipped) {
  std::vector<Field> fields;
  for (Entry& entry : entries) {
    const bool again = !fields.empty() && fields.back().entry.world->traits().name == entry.world->traits().name;
    MazeCollection mazes = find_mazes_of(entry, options.contests, again);
    skipped = std::move(mazes.skipped);
    fields.push_back({std::move(entry), std::move(mazes.mazes)});
  }
  return fields;
}

/// The results file of --out, which must not be the file of another option.
std::string results_path(const RaceOptions& options) {
  return options.out.empty() ? "" : fmt::format("{}/{}", options.out, results_file_name);
}

int race(const RaceOptions& options) {
  expect_outputs({{"--curves", options.curves, FileKind::picture, true},
                  {"--junit", options.junit, FileKind::junit},
                  {"--store", options.contests.store_path},
                  {"--out", results_path(options)},
                  {"--baseline", options.baseline}});
  std::optional<Holding> holding(options);
  std::vector<Entry> entries = options.contests.world.enter(find_contestants(
      with_mice_files(options.mice, options.mice_files), options.contests.world, options.external_mice));
  check_races(options, entries);
  std::vector<SkippedFile> skipped;
  std::vector<Field> fields = fields_of(options, std::move(entries), skipped);
  const auto baselines = load_baselines(options, fields);
  auto folder = take_folder(options.out, options.overwrite);
  const std::vector<Race> races = holding->hold(std::move(fields));
  std::string failed_write = holding->failed_write();
  holding.reset();  // ends the progress bar and the handling of Ctrl-C
  // Saved before anything is printed, because a reader of the table may leave early and end the program.
  if (failed_write.empty()) failed_write = save_results(options, races, skipped);
  folder.reset();
  if (failed_write.empty()) failed_write = save_junit(options, races);
  report(options, races, skipped);
  for (std::size_t i = 0; i < races.size(); ++i) {
    if (options.shares) add(options, shares_of(races[i]));
    if (options.worst > 0) add(options, worst_of(races[i], options.worst));
    if (baselines[i]) add(options, compare_with_baseline(races[i], *baselines[i]));
  }
  report_curves(options, races);
  if (const std::string robots = compare_robots(races); !robots.empty() && options.format == "table")
    print("\n" + robots);
  options.contests.finish_store(options.format == "table");
  if (!failed_write.empty()) throw UsageError(failed_write);
  if (std::any_of(races.begin(), races.end(), [](const Race& each) { return each.stopped; })) return exit_interrupted();
  std::string findings;
  for (const Race& each : races) {
    findings += never_started_lines(each);
    if (options.has_limit) findings += above_limit(options, each);
  }
  tell(findings);
  return findings.empty() ? exit_good : exit_finding;
}

}  // namespace

void add_race(Command& app, int& exit) {
  auto options = std::make_shared<RaceOptions>();
  Command* command = app.add_subcommand("race", "Race mice on many mazes and print a leaderboard");
  command->group(groups::mice);
  command
      ->add_option("--mice", options->mice,
                   "Mice: [NAME=]mouse[:key=value]..., separated by commas, or [NAME=]capstone:FILE, program:COMMAND, "
                   "controller:COMMAND, firmware:FILE, mms:COMMAND, mouse:parts=COMMAND (repeatable); default: all")
      ->type_name("SPEC")
      ->expected(1)
      ->take_all();
  add_mice_files(*command, options->mice_files);
  add_contests(*command, options->contests);
  command->group(groups::output);
  command->add_option("--format", options->format, "What is printed")
      ->check(one_of({"table", "json", "csv"}))
      ->capture_default_str();
  command->add_option("--columns", options->columns, "Columns of the table: the usual ones, or all")
      ->check(one_of({"usual", "all"}))
      ->capture_default_str();
  auto* out = command
                  ->add_option("--out", options->out,
                               "Folder for the records, one SVG per mouse and maze, and the results as JSON")
                  ->type_name("DIR");
  command->add_flag("--overwrite", options->overwrite, "Replace the files of an earlier race in --out DIR")->needs(out);
  command->add_option("--baseline", options->baseline, "Compare with the JSON of an earlier race, maze by maze")
      ->type_name("FILE");
  auto* limit = command
                    ->add_option("--fail-above", options->fail_above,
                                 "Exit with 1 if a mouse's mean score over all contests is above this")
                    ->type_name("SCORE")
                    ->check(finite_number());
  command
      ->add_option("--junit", options->junit,
                   "Write JUnit XML: a test for each contest, and one for the mean where there is --fail-above")
      ->type_name("FILE");
  command->add_option("--worst", options->worst, "Print the N mazes in which each mouse lost most")
      ->type_name("N")
      ->check(in_range(1, 1'000'000));
  command->group(groups::contests);
  auto* shard = add_shard(*command, options->contests.order.shard, "race");
  command->group(groups::output);
  command
      ->add_option("--curves", options->curves,
                   "Draw the share of finished contests against several values of --noise or --variation, and what "
                   "ended the others, as SVG")
      ->type_name("FILE");
  command->add_flag("--shares", options->shares,
                    "Print the shares of the mazes that each mouse discovered and visited");
  add_racing_options(*command, options->external_mice);
  command->footer(
      "Example: labmouse race --mice flood:stride=1,certify --mazes capstone-1 --format json > today.json\n"
      "         labmouse race --mice flood,certify --mazes capstone-1 --baseline today.json\n"
      "         labmouse race --world seconds --robot half --rules thirtieth\n"
      "         labmouse race --world physical --robot classic,./my-robot.toml\n"
      "         labmouse race --world failures --variation 0,0.5,1,1.2 --curves curves.svg");
  command->callback([options, limit, shard, &exit] {
    if (shard->count() > 0 && options->contests.store_path.empty())
      throw UsageError("error: --shard needs --store, which keeps the part of the race");
    options->has_limit = limit->count() > 0;
    exit = race(*options);
  });
}

}  // namespace labmouse::cli
