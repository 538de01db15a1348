// labmouse race: many mice on many mazes, and a leaderboard.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "command.hpp"
#include "contests.hpp"
#include "labmouse/lab/baseline.hpp"
#include "labmouse/lab/files.hpp"
#include "labmouse/lab/race_files.hpp"
#include "labmouse/lab/report.hpp"

namespace labmouse::cli {
namespace {

struct RaceOptions {
  std::vector<std::string> mice;
  Contests contests;
  std::string format = "table";
  std::string out;
  std::string baseline;
  double fail_above = 0.0;
  bool has_limit = false;
  int worst = 0;
  bool shares = false;
};

/// Holds the race; `failed_write` takes what went wrong with --out, which ends it early.
Race hold(const RaceOptions& options, std::vector<Contestant> mice, std::vector<NamedMaze> mazes, std::string& failed_write) {
  Progress progress;
  Interruptible interruptible;
  std::optional<RaceFolder> folder;
  RaceHooks hooks;
  hooks.stop = &interruptible.stopped();
  hooks.finished = [&](const Race& race, const ContestResult& contest, const RunRecord& record) {
    progress.advance(race.results.size());
    if (options.out.empty() || !failed_write.empty()) return;
    if (!folder) folder.emplace(options.out, race);
    failed_write = folder->save(race, contest, record);
    if (!failed_write.empty()) interruptible.stop();
  };
  return hold_race(std::move(mice), std::move(mazes), options.contests.order, hooks);
}

std::string report(const RaceOptions& options, const Race& race, const std::vector<SkippedFile>& skipped) {
  if (options.format == "json") return json_of(race, skipped);
  if (options.format == "csv") return csv_of(race);
  return table_of(race, colours());
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
  throw UsageError(fmt::format("{}: error: is not the JSON of a race (make one with `labmouse race --format json`)", options.baseline));
}

/// The mice whose mean over all contests is above the limit.
std::string above_limit(const RaceOptions& options, const Race& race) {
  std::string text;
  for (const Standing& standing : standings_of(race))
    if (standing.penalised_mean && *standing.penalised_mean > options.fail_above && !race.mice[standing.mouse].reference)
      text += fmt::format("{} scores {:.3f}, above the limit of {:g}\n", race.mice[standing.mouse].name,
                          *standing.penalised_mean, options.fail_above);
  return text;
}

int race(const RaceOptions& options) {
  std::vector<Contestant> mice = find_contestants(options.mice);
  const auto baseline = load_baseline(options);
  MazeCollection mazes = find_mazes(options.contests.mazes, options.contests.places);
  std::string failed_write;
  const Race result = hold(options, std::move(mice), std::move(mazes.mazes), failed_write);
  print(report(options, result, mazes.skipped));
  if (options.shares) add(options, shares_of(result));
  if (options.worst > 0) add(options, worst_of(result, options.worst));
  if (baseline) add(options, compare_with_baseline(result, *baseline));
  if (!failed_write.empty()) throw UsageError(failed_write);
  if (result.stopped) return exit_interrupted;
  const std::string above = options.has_limit ? above_limit(options, result) : "";
  tell(above);
  return above.empty() ? exit_good : exit_finding;
}

}  // namespace

void add_race(CLI::App& app, int& exit) {
  auto options = std::make_shared<RaceOptions>();
  CLI::App* command = app.add_subcommand("race", "Race many mice on many mazes and print the leaderboard");
  command->add_option("--mice", options->mice, "Mice: name[:key=value]..., several separated by commas (may repeat); default: all")
      ->type_name("SPEC")->expected(1)->take_all();
  add_contests(*command, options->contests);
  command->add_option("--format", options->format, "Output")->check(CLI::IsMember({"table", "json", "csv"}))->capture_default_str();
  command->add_option("--out", options->out, "Folder for records and one SVG a maze and mouse")->type_name("DIR");
  command->add_option("--baseline", options->baseline, "JSON of an earlier race: prints the paired difference")->type_name("FILE");
  auto* limit = command->add_option("--fail-above", options->fail_above, "Exit with 1 if a mouse's mean score over all is above this")
      ->type_name("SCORE")->check(finite_number());
  command->add_option("--worst", options->worst, "Print the N mazes that cost each mouse most")->type_name("N")->check(CLI::Range(1, 1'000'000));
  command->add_flag("--shares", options->shares, "Print how much of the mazes each mouse discovered and visited");
  command->footer("Example: labmouse race --mice flood:stride=1,certify --mazes my-mazes/ --format json > today.json\n"
                  "         labmouse race --mazes my-mazes/ --baseline today.json");
  command->callback([options, limit, &exit] {
    options->has_limit = limit->count() > 0;
    exit = race(*options);
  });
}

}  // namespace labmouse::cli
