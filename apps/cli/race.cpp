// labmouse race: many mice on many mazes, and a leaderboard.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "command.hpp"
#include "contests.hpp"
#include "guests.hpp"
#include "labmouse/lab/galleries/mms_folder.hpp"
#include "labmouse/lab/galleries/race_folder.hpp"
#include "labmouse/lab/races/never_started.hpp"
#include "labmouse/lab/standings/baseline.hpp"
#include "labmouse/lab/standings/mms_report.hpp"
#include "labmouse/lab/standings/mms_standings.hpp"
#include "labmouse/lab/standings/race_report.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "race_seconds.hpp"

namespace labmouse::cli {
namespace {

struct RaceOptions {
  std::vector<std::string> mice;
  Contests contests;
  MmsOptions mms;
  GuestOptions guests;
  std::string format = "table";
  std::string out;
  bool overwrite = false;
  std::string baseline;
  double fail_above = 0.0;
  bool has_limit = false;
  int worst = 0;
  bool shares = false;
  std::string world = "strides", robot = "classic", rules = "all-japan";
};

/// The races of both worlds; that of mms is there where it has mice.
struct Races {
  Race race;
  std::optional<MmsRace> mms;

  bool stopped() const { return race.stopped || (mms && mms->stopped); }
};

/// Holds the races and saves what --out asks for.
class Holding {
 public:
  explicit Holding(const RaceOptions& options) : options_(options) {}

  /// How guests are started, so that Ctrl-C ends them.
  GuestOptions guests() const {
    GuestOptions guests = options_.guests;
    guests.stop = &interruptible_.stopped();
    return guests;
  }

  Races hold(SpecResult mice, const std::vector<NamedMaze>& mazes) {
    all_ = contests_of(mice.contestants, mazes.size(), options_.contests.order) + mice.mms.size() * mazes.size();
    Races races;
    const bool mms = !mice.mms.empty();
    races.race = hold_race(std::move(mice.contestants), mazes, options_.contests.order, race_hooks());
    if (mms) races.mms = hold_mms_race(std::move(mice.mms), mazes, mms_order(), mms_hooks());
    return races;
  }

  /// What went wrong with --out, which ends the races early; or nothing.
  const std::string& failed_write() const { return failed_write_; }

 private:
  RaceHooks race_hooks() {
    RaceHooks hooks;
    hooks.stop = &interruptible_.stopped();
    hooks.finished = [this](const Race& race, const ContestResult& contest, const RunRecord& record) {
      progress_.advance(all_);
      if (options_.out.empty() || !failed_write_.empty()) return;
      if (!folder_) folder_.emplace(options_.out, race);
      note(folder_->save(race, contest, record));
    };
    return hooks;
  }

  MmsRaceHooks mms_hooks() {
    MmsRaceHooks hooks;
    hooks.stop = &interruptible_.stopped();
    hooks.finished = [this](const MmsRace& race, const MmsResult& result, const std::string& record) {
      progress_.advance(all_);
      if (options_.out.empty() || !failed_write_.empty()) return;
      if (!mms_folder_) mms_folder_.emplace(options_.out, race);
      note(mms_folder_->save(result, record));
    };
    return hooks;
  }

  MmsRaceOrder mms_order() const {
    return {options_.mms, options_.contests.order.seed, options_.contests.order.jobs, !options_.out.empty()};
  }

  void note(const std::string& failed_write) {
    failed_write_ = failed_write;
    if (!failed_write.empty()) interruptible_.stop();
  }

  const RaceOptions& options_;
  Progress progress_;
  Interruptible interruptible_;
  std::size_t all_ = 0;
  std::optional<RaceFolder> folder_;
  std::optional<MmsRaceFolder> mms_folder_;
  std::string failed_write_;
};

std::string report(const RaceOptions& options, const Races& races, const std::vector<SkippedFile>& skipped) {
  const MmsRace* mms = races.mms ? &*races.mms : nullptr;
  const bool only_mms = mms != nullptr && races.race.mice.empty();
  if (options.format == "json") return json_of(races.race, skipped, mms);
  if (options.format == "csv") return only_mms ? csv_of(*mms) : csv_of(races.race);
  if (only_mms) return table_of(*mms, colours());
  return table_of(races.race, colours()) + (mms != nullptr ? "\n" + table_of(*mms, colours()) : "");
}

/// Saves the results beside the records. Returns what went wrong, or nothing.
std::string save_results(const RaceOptions& options, const Races& races, const std::vector<SkippedFile>& skipped) {
  if (options.out.empty()) return "";
  const std::string path = fmt::format("{}/{}", options.out, results_file_name);
  const std::string error = write_file(path, json_of(races.race, skipped, races.mms ? &*races.mms : nullptr));
  return error.empty() ? "" : fmt::format("{}: error: {}", path, error);
}

/// Throws UsageError for what the mice of mms cannot have.
void require_sense(const RaceOptions& options, const SpecResult& mice) {
  if (mice.mms.empty()) return;
  const Places& places = options.contests.places;
  if (!places.start.empty() || !places.goals.empty())
    throw UsageError("error: --start and --goal are not for mms, which starts at (0,0) and has its goal in the centre");
  if (options.format == "csv" && !mice.contestants.empty())
    throw UsageError("error: --format csv holds one world; race the mice of mms alone, or take --format json");
  if (mice.contestants.empty() && (options.shares || options.worst > 0 || !options.baseline.empty()))
    throw UsageError("error: --baseline, --shares and --worst are not for mms, and all of the mice are mice of mms");
}

/// What is more than the results goes beside them: below a table, to standard error where a program reads the output.
void add(const RaceOptions& options, const std::string& text) {
  if (options.format == "table")
    print("\n" + text);
  else
    tell(text);
}

std::optional<Baseline> load_baseline(const RaceOptions& options) {
  if (options.baseline.empty()) return std::nullopt;
  const FileContent file = read_file(options.baseline, std::size_t{1} << 30U);
  if (!file.error.empty()) throw UsageError(fmt::format("{}: error: {}", options.baseline, file.error));
  auto baseline = read_baseline(file.content, options.contests.order.rules);
  if (baseline) return baseline;
  throw UsageError(fmt::format("{}: error: is not the JSON of a race (make one with `labmouse race --format json`)",
                               options.baseline));
}

std::string above_limit(const RaceOptions& options, const std::string& mouse, const std::optional<double>& mean) {
  if (!mean || *mean <= options.fail_above) return "";
  return fmt::format("{} scores {:.3f}, above the limit of {:g}\n", mouse, *mean, options.fail_above);
}

/// The mice whose mean over all contests is above the limit.
std::string above_limit(const RaceOptions& options, const Races& races) {
  std::string text;
  for (const Standing& standing : standings_of(races.race))
    if (const Contestant& mouse = races.race.mice[standing.mouse]; !mouse.reference)
      text += above_limit(options, mouse.name, standing.penalised_mean);
  if (!races.mms) return text;
  for (const MmsStanding& standing : mms_standings_of(*races.mms))
    text += above_limit(options, shown(races.mms->mice[standing.mouse].name), standing.mean_score);
  return text;
}

int race(const RaceOptions& options) {
  std::optional<Holding> holding(options);
  SpecResult mice = find_mice(options.mice, holding->guests());
  require_sense(options, mice);
  const auto baseline = load_baseline(options);
  const MazeCollection mazes = find_mazes(options.contests.mazes, options.contests.places);
  auto folder = take_folder(options.out, options.overwrite);
  const Races races = holding->hold(std::move(mice), mazes.mazes);
  std::string failed_write = holding->failed_write();
  holding.reset();  // the bar, and what Ctrl-C does
  // Before anything is printed: a reader of the table may leave early.
  if (failed_write.empty()) failed_write = save_results(options, races, mazes.skipped);
  folder.reset();
  print(report(options, races, mazes.skipped));
  if (options.shares) add(options, shares_of(races.race));
  if (options.worst > 0) add(options, worst_of(races.race, options.worst));
  if (baseline) add(options, compare_with_baseline(races.race, *baseline));
  if (!failed_write.empty()) throw UsageError(failed_write);
  if (races.stopped()) return exit_interrupted();
  const std::string findings = never_started_lines(races.race) + (races.mms ? never_started_lines(*races.mms) : "") +
                               (options.has_limit ? above_limit(options, races) : "");
  tell(findings);
  return findings.empty() ? exit_good : exit_finding;
}

SecondsRace in_seconds(const RaceOptions& options) {
  SecondsRace race;
  race.mice = options.mice;
  race.contests = options.contests;
  race.robot = options.robot;
  race.rules = options.rules;
  race.format = options.format;
  race.out = options.out;
  race.overwrite = options.overwrite;
  if (options.has_limit) race.fail_above = options.fail_above;
  return race;
}

/// Throws UsageError for an option of another world than that of the race.
void require_world(const CLI::App& command, const RaceOptions& options) {
  const bool seconds = options.world == "seconds";
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    const std::string name = option->get_name();
    if (!seconds && (name == "--robot" || name == "--rules"))
      throw UsageError(fmt::format("error: {} is for the world of seconds; add --world seconds", name));
    constexpr std::array<std::string_view, 13> shared = {"--overwrite", "--world",  "--robot", "--rules", "--mice",
                                                         "--mazes",     "--start",  "--goal",  "--runs",  "--seed",
                                                         "--jobs",      "--format", "--out"};
    if (seconds && name != "--fail-above" && std::find(shared.begin(), shared.end(), name) == shared.end())
      throw UsageError(fmt::format("error: {} is not for the world of seconds", name));
  }
}

void add_world(CLI::App& command, RaceOptions& options) {
  command.add_option("--world", options.world, "What moves cost: strides or seconds")
      ->check(CLI::IsMember({"strides", "seconds"}))
      ->capture_default_str();
  add_robot_option(command, options.robot);
  command
      .add_option("--rules", options.rules,
                  "Name of built-in rules in seconds, or a file with a slash or .toml in its name")
      ->type_name("RULES")
      ->capture_default_str();
}

}  // namespace

void add_race(CLI::App& app, int& exit) {
  auto options = std::make_shared<RaceOptions>();
  CLI::App* command = app.add_subcommand("race", "Race many mice on many mazes and print the leaderboard");
  command
      ->add_option("--mice", options->mice,
                   "Mice: name[:key=value]..., several separated by commas, or capstone:FILE, guest:COMMAND, "
                   "mms:COMMAND (may repeat); default: all")
      ->type_name("SPEC")
      ->expected(1)
      ->take_all();
  add_world(*command, *options);
  add_contests(*command, options->contests);
  command->add_option("--format", options->format, "Output")
      ->check(CLI::IsMember({"table", "json", "csv"}))
      ->capture_default_str();
  auto* out =
      command
          ->add_option("--out", options->out, "Folder for records, one SVG a maze and mouse, and the results as JSON")
          ->type_name("DIR");
  command->add_flag("--overwrite", options->overwrite, "Replace what an earlier race left in --out DIR")->needs(out);
  command->add_option("--baseline", options->baseline, "JSON of an earlier race: prints the paired difference")
      ->type_name("FILE");
  auto* limit = command
                    ->add_option("--fail-above", options->fail_above,
                                 "Exit with 1 if a mouse's mean score over all is above this")
                    ->type_name("SCORE")
                    ->check(finite_number());
  command->add_option("--worst", options->worst, "Print the N mazes that cost each mouse most")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000));
  command->add_flag("--shares", options->shares, "Print how much of the mazes each mouse discovered and visited");
  add_mms_options(*command, options->mms);
  add_python(*command, options->guests);
  add_guest_options(*command, options->guests);
  command
      ->add_option("--guest-runs", options->guests.runs,
                   "Contests of each guest in each maze, for those that throw dice")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->footer(
      "Example: labmouse race --mice flood:stride=1,certify --mazes my-mazes/ --format json > today.json\n"
      "         labmouse race --mazes my-mazes/ --baseline today.json\n"
      "         labmouse race --world seconds --robot half --rules thirtieth");
  command->callback([options, command, limit, &exit] {
    options->has_limit = limit->count() > 0;
    require_world(*command, *options);
    exit = options->world == "seconds" ? race_in_seconds(in_seconds(*options)) : race(*options);
  });
}

}  // namespace labmouse::cli
