// labmouse mice-file: checks and writes mice files.
#include "labmouse/lab/mice_files/mice_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "external.hpp"
#include "labmouse/contest/code_contest.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/external/capstone.hpp"
#include "labmouse/external/command_line.hpp"
#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/mice_files/mice_scan.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/last_lines.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse::cli {
namespace {

struct CheckOptions {
  std::string file;
  ExternalOptions external_mice;
};

/// The result of one contest of a mouse.
struct Trial {
  bool good = false;
  std::string how;   ///< the result in words
  std::string last;  ///< the last line of its messages
  std::string walk;  ///< everything that must be the same in a second contest
};

Trial try_in_steps(const Contestant& mouse, const Maze& maze) {
  const Rules rules;
  constexpr std::uint64_t seed = 1;
  const auto strategy = mouse.strategy(maze, brief(maze, rules, seed));
  const RunRecord record = labmouse::run(maze, rules, *strategy);
  const Score result = score(record, rules);
  Trial trial;
  for (const StepRecord& step : record.steps)
    trial.walk +=
        fmt::format("{} {} {};", static_cast<int>(step.action.kind), step.action.rotation, step.action.movement);
  trial.good = record.outcome != Outcome::forfeit || record.steps.back().action.reason == ForfeitReason::gave_up;
  const std::string_view words = record.last_words;
  const auto lines = last_lines(words);
  if (!lines.empty()) trial.last = lines.back();
  if (result.value)
    trial.how = fmt::format("finished, score {:.3f}", *result.value);
  else if (record.outcome == Outcome::forfeit)
    trial.how = words.substr(0, words.find('\n'));
  else
    trial.how = fmt::format("plays, but does not solve it: {}", name_of(result.outcome));
  return trial;
}

Trial try_in_mms(const MmsProgram& program, const Maze& maze) {
  const MmsRun run = run_mms(program.launch, maze, {});
  Trial trial;
  trial.walk = fmt::format("{} {} {} {} {}", run.lines, run.clock, run.statistics.total_distance,
                           run.statistics.total_turns, run.statistics.score);
  trial.good = run.outcome == MmsOutcome::complete || (run.outcome == MmsOutcome::waiting && run.lines > 0);
  const auto lines = last_lines(run.errors);
  if (!lines.empty()) trial.last = lines.back();
  if (!trial.good)
    trial.how = fmt::format("{}: {}", name_of(run.outcome), run.end);
  else
    trial.how = run.statistics.finished ? fmt::format("finished, score {:g}", run.statistics.score)
                                        : "plays, but does not reach the centre";
  return trial;
}

/// A contest in the physical world.
struct PhysicalTrial {
  DriveModel model = find_robot("kerise").model;
  DriveRules rules = find_rules("all-japan").rules;
  PhysicalConditions conditions;
  std::uint64_t seed = 1;

  ControllerBriefing briefing(const Maze& maze) const {
    return controller_briefing(maze, rules, model, conditions, seed);
  }
  /// `reason`: why the program gave up. A mouse that only got lost works.
  Trial result(const PhysicalRecord& record, ForfeitReason reason, std::string_view words) const {
    const DriveScore result = score(record.drive, rules);
    Trial trial;
    for (const ControllerTick& tick : record.tape)
      trial.walk += fmt::format("{} {} {};", static_cast<int>(tick.word), tick.left, tick.right);
    for (const TracePoint& point : record.trace)
      trial.walk += fmt::format("{} {};", point.truth.position.x, point.truth.position.y);
    trial.good = reason == ForfeitReason::none || reason == ForfeitReason::gave_up;
    const auto lines = last_lines(words);
    if (!lines.empty()) trial.last = lines.back();
    if (!trial.good)
      trial.how = words.substr(0, words.find('\n'));
    else
      trial.how = result.value() ? fmt::format("finished, score {:.3f} s", static_cast<double>(*result.value()) / 1e6)
                                 : "plays, but no run of it counts";
    return trial;
  }
};

Trial try_physically(const ControllerProgram& program, const Maze& maze) {
  const PhysicalTrial trial;
  const auto code = program(trial.briefing(maze));
  const PhysicalRecord record = drive_by_code(maze, trial.rules, trial.model, trial.conditions, trial.seed, *code);
  return trial.result(record, record.drive.reason, code->last_words());
}

/// A mouse whose controller has external parts. It is asked each millisecond, so that 20 s have to do.
Trial try_with_parts(const Contestant& mouse, const Maze& maze) {
  PhysicalTrial trial;
  trial.rules.time_limit = 20'000'000;
  trial.conditions.trace_every = 100;
  Briefing briefing = brief(maze, trial.rules, trial.model, trial.seed);
  briefing.sight = 1;
  const auto strategy = mouse.driving_strategy(maze, briefing);
  const auto program = mouse.parts(trial.briefing(maze));
  const ControllerParts parts = program->parts();
  const PhysicalRecord record =
      drive_physically(maze, trial.rules, trial.model, trial.conditions, trial.seed, *strategy, parts);
  return trial.result(record, parts.reason(), program->last_words());
}

Trial try_in_seconds(const Contestant& mouse, const Maze& maze) {
  const DriveModel model = find_robot("kerise").model;
  const DriveRules rules = find_rules("all-japan").rules;
  const auto strategy = mouse.driving_strategy(maze, brief(maze, rules, model, 1));
  const DriveRecord record = drive(maze, rules, model, *strategy);
  const auto score = labmouse::score(record, rules).value();
  Trial trial;
  for (const DriveRun& run : record.runs) {
    trial.walk += fmt::format("{};", run.end);
    for (const SearchMove& move : run.moves)
      trial.walk += fmt::format("{} {};", move.action.rotation, move.action.movement);
  }
  trial.good = record.reason == ForfeitReason::none || record.reason == ForfeitReason::gave_up;
  trial.how = !trial.good ? fmt::format("forfeit: {}", name_of(record.reason))
              : score     ? fmt::format("finished, score {:.3f} s", static_cast<double>(*score) / 1e6)
                          : "plays, but no run of it counts";
  return trial;
}

/// Runs a contest in the first world that accepts the mouse.
Trial try_out(const Contestant& mouse, const Maze& maze) {
  if (const auto* program = std::get_if<MmsProgram>(&mouse.kind)) return try_in_mms(*program, maze);
  if (const auto* program = std::get_if<ControllerProgram>(&mouse.kind)) return try_physically(*program, maze);
  if (mouse.parts) return try_with_parts(mouse, maze);
  return refuse_to_walk(mouse).empty() ? try_in_steps(mouse, maze) : try_in_seconds(mouse, maze);
}

std::string kind_of(const Contestant& mouse) {
  const std::string spec = mouse.spec.substr(0, mouse.spec.find(':'));
  return mouse.sandboxed && !mouse.parts ? spec : "mouse";
}

/// Prints a line about the mouse; returns whether it works.
bool check_one(const Contestant& mouse, const Maze& maze, std::size_t width) {
  const Trial first = try_out(mouse, maze);
  const bool same = !first.good || try_out(mouse, maze).walk == first.walk;
  std::string line = fmt::format("{:<{}} {:<8} ", shown(mouse.name), width, kind_of(mouse));
  if (mouse.interpreter && !mouse.interpreter->version.empty())
    line += fmt::format("Python {:<7} ", mouse.interpreter->version);
  line += fmt::format("{}{}", first.good ? "" : "error: ", shown(first.how));
  if (!same) line += "; differs from run to run: it reads the clock, or uses random numbers of its own";
  if (!first.good && !first.last.empty() && first.how.find(first.last) == std::string::npos)
    line += fmt::format("\n{:<{}} | {}", "", width, shown(first.last));
  print(line + "\n");
  return first.good;
}

/// Reads a mice file; throws UsageError with all its problems.
std::vector<MiceFileEntry> mice_file_of(const std::string& path) {
  const FileContent file = read_file(path);
  if (!file.error.empty()) throw UsageError(fmt::format("{}: error: {}", path, file.error));
  refuse_other_kind(path, file.content, FileKind::unknown);
  MiceFileResult mice_file = read_mice_file(file.content);
  std::string problems;
  for (const Problem& problem : mice_file.problems)
    problems += (problems.empty() ? "" : "\n") + describe(path, problem);
  if (!problems.empty()) throw UsageError(problems);
  return std::move(mice_file.mice);
}

int check(CheckOptions options) {
  const NamedMaze maze = find_maze("capstone-1", {});
  const std::vector<MiceFileEntry> mice_file = mice_file_of(options.file);
  const Interruptible interruptible;
  options.external_mice.stop = &interruptible.stopped();
  std::size_t width = 0;
  for (const MiceFileEntry& mouse : mice_file) width = std::max(width, mouse.name.size());
  bool good = true;
  std::vector<Contestant> tried;
  for (const MiceFileEntry& mouse : mice_file) {
    const SpecResult read = read_specs("mice-file:" + options.file + ":" + mouse.name, options.external_mice);
    if (read.error.empty())
      good = check_one(tried.emplace_back(read.contestants.front()), maze.maze, width) && good;
    else
      print(fmt::format("{:<{}} {:<8} error: {}\n", mouse.name, width, key_of(mouse.kind), shown(read.error)));
    good = good && read.error.empty();
    if (interruptible.stopped()) return exit_interrupted();
  }
  print(freedom_note(tried));
  return good ? exit_good : exit_finding;
}

/// The name of a working Python 2 in PATH, or nothing. Some programs of that name only print that it is missing.
std::string python_2() {
  for (const char* name : {"python2", "python2.7"})
    if (!program_path(name, "").empty() && !python_version(name, false).empty()) return name;
  return "";
}

void init(const std::string& folder, bool overwrite) {
  const std::vector<FoundMouse> mice = scan_for_mice(folder, python_2());
  if (std::none_of(mice.begin(), mice.end(), [](const FoundMouse& mouse) { return !mouse.kind.empty(); }))
    throw UsageError(
        fmt::format("{}: error: no robots here: no Python file with a class Robot, and no program that "
                    "speaks to labmouse or mms",
                    folder));
  const std::string path = (std::filesystem::path(folder) / "mice.toml").string();
  if (!overwrite && std::filesystem::exists(path))
    throw UsageError(fmt::format("{}: error: this file exists already; --overwrite replaces it", path));
  save(path, mice_file_text(mice));
  for (const FoundMouse& mouse : mice)
    print(fmt::format("{}: {}\n", shown(mouse.name),
                      mouse.kind.empty() ? mouse.remark
                                         : fmt::format("{} {}{}{}", mouse.kind, shown(mouse.file),
                                                       mouse.interpreter.empty() ? "" : ", " + shown(mouse.interpreter),
                                                       mouse.remark.empty() ? "" : "; " + mouse.remark)));
  print(fmt::format("wrote {}; try it out with: labmouse mice-file check {}\n", path, path));
}

}  // namespace

void add_mice_file(Command& app, int& exit) {
  Command* command = app.add_subcommand("mice-file", "Write and test a mice file: names of mice with their commands");
  command->require_subcommand();
  auto options = std::make_shared<CheckOptions>();
  Command* check_command = command->add_subcommand(
      "check", "Run the commands of a mice file: each mouse twice in a small maze, and report what is wrong");
  check_command->add_option("file", options->file, "Mice file")->required()->type_name("FILE");
  add_runners(*check_command, options->external_mice);
  add_external_options(*check_command, options->external_mice);
  check_command->footer("Example: labmouse mice-file check class/mice.toml");
  check_command->callback([options, &exit] { exit = check(*options); });
  auto folder = std::make_shared<std::string>();
  auto overwrite = std::make_shared<bool>(false);
  Command* init_command = command->add_subcommand("init", "Write FOLDER/mice.toml with the robots in FOLDER");
  init_command->add_option("folder", *folder, "A folder of robots, or of folders with one robot each")
      ->required()
      ->type_name("FOLDER")
      ->check(existing_directory());
  init_command->add_flag("--overwrite", *overwrite, "Replace an existing mice.toml");
  init_command->footer("Example: labmouse mice-file init class/");
  init_command->callback([folder, overwrite, &exit] {
    init(*folder, *overwrite);
    exit = exit_good;
  });
  command->footer(
      "Example: labmouse mice-file init class/\n         labmouse mice-file check class/mice.toml\n"
      "         labmouse race --mice-file class/mice.toml");
}

}  // namespace labmouse::cli
