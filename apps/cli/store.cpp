// labmouse store: lists, merges, checks and cleans up stores of contests.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "external.hpp"
#include "labmouse/external/sandbox.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/store/store_changes.hpp"
#include "labmouse/lab/store/stored_races.hpp"
#include "labmouse/lab/store/verification.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse::cli {
namespace {

struct StoreOptions {
  std::string file;
  StoreFilter filter;
  std::string format = "table";
  int most = 20;
  std::vector<std::string> parts;
  std::string target;
  VerificationOrder verification;
  bool run_programs = false;
};

/// Adds a command of `store` with its file and its filter options.
Command* add(Command& command, StoreOptions& options, const std::string& name, const std::string& meaning) {
  Command* added = command.add_subcommand(name, meaning);
  added->add_option("file", options.file, "The store")->required()->type_name("FILE");
  const auto add_names = [&](const char* option, std::vector<std::string>& names, const char* what) {
    added->add_option(option, names, what)->type_name("NAME")->expected(1)->take_all();
  };
  add_names("--world", options.filter.worlds, "Only contests in this world (repeatable)");
  add_names("--mouse", options.filter.mice, "Only contests of the mouse of this name (repeatable)");
  add_names("--maze", options.filter.mazes, "Only contests in the maze of this name (repeatable)");
  add_names("--version", options.filter.versions, "Only contests that this version of labmouse ran (repeatable)");
  added
      ->add_integer(
          "--seed", [&options](std::uint64_t seed) { options.filter.race_seed = seed; },
          "Only contests of races with this seed")
      ->check(seed_number());
  return added;
}

std::string day_of(std::int64_t time) {
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(static_cast<std::time_t>(time)));
}

ExitCode list(const StoreOptions& options) {
  const StoredMice found = stored_mice(options.file, options.filter);
  if (!found.error.empty()) throw UsageError(found.error);
  std::size_t world = 5, mouse = 5;
  for (const StoredMouse& each : found.mice) {
    world = std::max(world, each.world.size());
    mouse = std::max(mouse, each.mouse.size());
  }
  std::string text = fmt::format("{:<{}} {:<{}} {:>6} {:>8} {:>7} {:>9}  {:<10}  {:<10}\n", "world", world, "mouse",
                                 mouse, "mazes", "contests", "finished", "mean", "first", "last");
  for (const StoredMouse& each : found.mice)
    text += fmt::format("{:<{}} {:<{}} {:>6} {:>8} {:>7} {:>9}  {}  {}", shown(each.world), world, shown(each.mouse),
                        mouse, each.mazes, each.contests, each.finished,
                        each.mean ? fmt::format("{:.3f}", *each.mean) : "-", day_of(each.first), day_of(each.last)) +
            (each.apart.empty() ? "" : "  " + shown(each.apart)) + "\n";
  print(text);
  return exit_good;
}

/// An exported contest in lines for people.
std::string lines_of_contest(const Json& json) {
  const auto text = [&](const char* key) {
    return json[key].is_string() ? json[key].get<std::string>() : json[key].dump();
  };
  return shown(fmt::format("{} in {}, world {}, seed {}: {}, score {}", text("mouse"), text("maze"), text("world"),
                           text("seed"), text("outcome"), text("score"))) +
         "\n" +
         shown(fmt::format("    {} labmouse {}, {}, {}",
                           fmt::format("{:%Y-%m-%d %H:%M:%S}",
                                       fmt::gmtime(static_cast<std::time_t>(json["time"].get<std::int64_t>()))),
                           text("version"), text("compiler"), text("processor"))) +
         "\n" + shown("    " + text("fields")) + "\n";
}

ExitCode show(const StoreOptions& options) {
  const std::string error =
      export_store(options.file, options.filter, ExportFormat::json_lines, options.most, [](const std::string& lines) {
        for (std::size_t begin = 0; begin < lines.size();) {
          const auto end = lines.find('\n', begin);
          print(lines_of_contest(Json::parse(lines.substr(begin, end - begin))));
          begin = end + 1;
        }
        return true;
      });
  if (!error.empty()) throw UsageError(error);
  return exit_good;
}

ExitCode race_again(const StoreOptions& options) {
  const StoredRaces found = stored_races(options.file, options.filter);
  if (!found.error.empty()) throw UsageError(found.error);
  if (options.format == "csv" && found.races.size() > 1)
    throw UsageError("error: --format csv can hold only one race; name its --world, or use --format json");
  std::string text;
  if (options.format == "json") write_json(found.races, {}, print_part);
  for (const Race& race : found.races) {
    if (options.format == "csv") write_csv(race, print_part);
    if (options.format == "table") text += (text.empty() ? "" : "\n") + table_of(race, colours());
  }
  print(text);
  for (const std::string& remark : found.remarks) tell(remark + "\n");
  return exit_good;
}

ExitCode export_rows(const StoreOptions& options) {
  const auto format = options.format == "csv" ? ExportFormat::csv : ExportFormat::json_lines;
  const std::string error = export_store(options.file, options.filter, format, 0, [](const std::string& lines) {
    print(lines);
    return true;
  });
  if (!error.empty()) throw UsageError(error);
  return exit_good;
}

ExitCode merge(const StoreOptions& options) {
  const Merge merged = merge_stores(options.parts, options.target);
  if (!merged.error.empty()) throw UsageError(merged.error);
  for (const std::string& conflict : merged.conflicts) tell(conflict + "\n");
  if (!merged.conflicts.empty()) {
    tell("Nothing was merged: the same contest has another result in two stores.\n");
    return exit_finding;
  }
  print(fmt::format("{} added to {}, {} in more than one store with equal results.\n",
                    counted(merged.added, "contest", "contests"), shown(options.target), merged.equal));
  return exit_good;
}

/// Explains why picked contests were not re-run.
std::string left_out(const Verification& found) {
  std::string text;
  if (found.impossible > 0)
    text += fmt::format(" Of {} the mouse is not here: another build, another file, or taught by a study.",
                        counted(found.impossible, "other", "others"));
  if (found.not_run > 0)
    text +=
        fmt::format(" {} left out, because the store names a program for it; --run-programs runs it in a sandbox:\n",
                    counted(found.not_run, "contest", "contests"));
  for (const std::string& program : found.programs) text += "    " + shown(program) + "\n";
  return text.ends_with('\n') ? text : text + "\n";
}

ExitCode verify(StoreOptions options) {
  if (options.run_programs) {
    if (options.verification.external_mice.sandbox == SandboxUse::never)
      throw UsageError("error: store verify runs the programs of a store only in a sandbox; leave out --sandbox off");
    if (const std::string reason = why_no_sandbox(); !reason.empty())
      throw UsageError(
          fmt::format("error: the programs of a store are only run in a sandbox, and this system has none ({}); leave "
                      "out --run-programs",
                      reason));
    options.verification.may_run = [](const std::string& program) {
      tell(fmt::format("runs in a sandbox: {}\n", shown(program)));
      return true;
    };
  }
  const Interruptible interruptible;
  options.verification.stop = options.verification.external_mice.stop = &interruptible.stopped();
  const Verification found = verify_store(options.file, options.filter, options.verification);
  if (!found.error.empty()) throw UsageError(found.error);
  for (const std::string& remark : found.remarks) tell(remark + "\n");
  for (const std::string& difference : found.differences) print(difference + "\n");
  std::string text = fmt::format("{} re-run: {} equal, {} not.", counted(found.held, "contest", "contests"),
                                 found.equal, found.differences.size());
  if (found.stopped) text += " Stopped early.";
  print(text + left_out(found));
  if (found.stopped) return exit_interrupted();
  return found.differences.empty() ? exit_good : exit_finding;
}

ExitCode forget_some(const StoreOptions& options) {
  if (condition_of(options.filter).empty())
    throw UsageError("error: name the contests to delete with --world, --mouse, --maze, --version or --seed");
  const Forgotten forgotten = forget(options.file, options.filter);
  if (!forgotten.error.empty()) throw UsageError(forgotten.error);
  print(fmt::format("{} deleted.\n", counted(forgotten.contests, "contest", "contests")));
  return exit_good;
}

}  // namespace

void add_store(Command& app, int& exit) {
  auto options = std::make_shared<StoreOptions>();
  Command* command = app.add_subcommand("store", "List, merge, check and clean up stores of contests");
  command->require_subcommand();
  Command* list_command = add(*command, *options, "list", "Print a line for each mouse of the store");
  list_command->footer("Example: labmouse store list results.db --world seconds");
  list_command->callback([options, &exit] { exit = list(*options); });
  Command* show_command =
      add(*command, *options, "show", "Print the last contests with all that the store knows of them");
  show_command->add_option("--last", options->most, "Number of contests")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str();
  show_command->footer("Example: labmouse store show results.db --mouse flood --last 5");
  show_command->callback([options, &exit] { exit = show(*options); });
  Command* race_command = add(*command, *options, "race", "Print the leaderboard of a race that the store holds");
  race_command->add_option("--format", options->format, "What is printed")
      ->check(one_of({"table", "json", "csv"}))
      ->capture_default_str();
  race_command->footer("Example: labmouse store race results.db --mouse flood --mouse certify");
  race_command->callback([options, &exit] { exit = race_again(*options); });
  auto lines = std::make_shared<std::string>("jsonl");
  Command* export_command = add(*command, *options, "export", "Print all contests, one a line");
  export_command->add_option("--format", *lines, "JSON lines or CSV")
      ->check(one_of({"jsonl", "csv"}))
      ->capture_default_str();
  export_command->footer("Example: labmouse store export results.db --format csv > contests.csv");
  export_command->callback([options, lines, &exit] {
    options->format = *lines;
    exit = export_rows(*options);
  });
  Command* merge_command =
      command->add_subcommand("merge", "Merge the contests of several stores, or list those with different results");
  merge_command->add_option("files", options->parts, "The stores")->required()->type_name("FILE")->expected(1, 1 << 20);
  merge_command->add_option("-o,--out,--output", options->target, "Store to add them to; a new one is created")
      ->required()
      ->type_name("FILE");
  merge_command->footer("Example: labmouse store merge part-*.db -o all.db");
  merge_command->callback([options, &exit] { exit = merge(*options); });
  Command* verify_command =
      add(*command, *options, "verify", "Check the file and re-run a random sample of its contests");
  verify_command->add_option("--share", options->verification.share, "Share of the contests to re-run")
      ->check(finite_number())
      ->check(in_range(0.0, 1.0))
      ->capture_default_str();
  verify_command->add_option("--pick", options->verification.seed, "Seed of the choice of contests")
      ->check(seed_number())
      ->capture_default_str();
  verify_command->add_option("--jobs", options->verification.jobs, "Number of threads; 0 uses all processors")
      ->check(in_range(0, 1024))
      ->capture_default_str();
  verify_command->add_flag("--run-programs", options->run_programs,
                           "Also re-run external mice, by their commands in the store, in a sandbox");
  add_runners(*verify_command, options->verification.external_mice);
  add_external_options(*verify_command, options->verification.external_mice);
  verify_command->footer("Example: labmouse store verify results.db --share 0.1");
  verify_command->callback([options, &exit] { exit = verify(*options); });
  Command* forget_command = add(*command, *options, "forget", "Delete contests");
  forget_command->footer("Example: labmouse store forget results.db --mouse flood");
  forget_command->callback([options, &exit] { exit = forget_some(*options); });
  command->footer(
      "Example: labmouse race --mice flood,certify --store results.db\n         labmouse store race results.db\n"
      "         labmouse store merge part-*.db -o all.db");
}

}  // namespace labmouse::cli
