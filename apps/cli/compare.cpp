// labmouse compare: races pairs of contests until it is decided which mouse is better.
#include "labmouse/lab/studies/compare.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "command.hpp"
#include "contests.hpp"
#include "external.hpp"
#include "generated.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "named_things.hpp"
#include "terminal.hpp"

namespace labmouse::cli {
namespace {

struct CompareOptions {
  const Command* command = nullptr;
  std::vector<std::string> mice, mice_files;
  Contests contests;
  ExternalOptions external_mice;
  SequentialOrder test;
  GeneratedMazes generated;
  std::uint64_t most = CompareOrder().most;
  std::string method = "bets", format = "table";
};

/// The mice: the first one, and those that are compared with it.
Entry entry_of(const CompareOptions& options) {
  if (options.mice.empty() && options.mice_files.empty())
    throw UsageError("error: mice are missing; name the first one, and those to compare with it");
  Entry entry = options.contests.world.enter_one(find_contestants(with_mice_files(options.mice, options.mice_files),
                                                                  options.contests.world, options.external_mice));
  if (entry.mice.size() < 2) throw UsageError("error: there is nothing to compare; name two mice or more that differ");
  return entry;
}

/// The mazes on the command line, or generated ones; the world of the entry gets the defaults for them.
MazeSource source_of(const CompareOptions& options, Entry& entry) {
  MazeSource source;
  const bool listed = !options.contests.mazes.empty();
  for (const char* option : {"--generator", "--size", "--loops"})
    if (listed && options.command->count(option) > 0)
      throw UsageError(fmt::format("error: {} is for generated mazes; leave out either it or --mazes", option));
  for (const char* option : {"--start", "--goal"})
    if (!listed && options.command->count(option) > 0)
      throw UsageError(fmt::format("error: {} is for given mazes; add --mazes", option));
  if (listed) {
    source.list = find_mazes_of(entry, options.contests).mazes;
    return source;
  }
  source.generator = &options.generated.generator();
  source.order = options.generated.order(1);
  const NamedMaze sample = drawn_maze(source, options.contests.order.seed, 0);
  suit_defaults(entry, {&sample, 1});
  if (const std::string reason = entry.world->refuse(sample.maze); !reason.empty())
    throw UsageError(
        fmt::format("error: generated mazes ({}, {}): {}", options.generated.kind, options.generated.size, reason));
  return source;
}

/// A line on a terminal with all candidates so far, which the next one overwrites.
std::string progress_of(const Compared& compared) {
  std::string text = fmt::format("\r{} mazes", compared.mazes);
  for (const ComparedMouse& candidate : compared.candidates)
    text += candidate.verdict == SequentialVerdict::undecided
                ? fmt::format(", {}: {:+.4f} to {:+.4f}", shown(candidate.mouse), candidate.interval.low,
                              candidate.interval.high)
                : fmt::format(", {}: {}", shown(candidate.mouse), name_of(candidate.verdict));
  return text + "\x1b[K";
}

Compared hold(const CompareOptions& options, const Entry& entry, MazeSource source) {
  CompareOrder order;
  order.mazes = std::move(source);
  order.race = options.contests.order_in(entry.world);
  order.test = options.test;
  order.test.method = options.method == "gsprt" ? SequentialMethod::gsprt : SequentialMethod::bets;
  order.most = options.most;
  const Interruptible interruptible;
  CompareHooks hooks;
  hooks.stop = &interruptible.stopped();
  const bool watched = is_terminal(stderr);
  if (watched) hooks.advanced = [](const Compared& compared) { tell(progress_of(compared)); };
  Compared compared = hold_comparison(entry.mice, order, hooks);
  if (watched) tell("\r\x1b[K");
  return compared;
}

int compare(const CompareOptions& options) {
  expect_outputs({{"--store", options.contests.store_path}});
  Entry entry = entry_of(options);
  MazeSource source = source_of(options, entry);
  const Compared compared = hold(options, entry, std::move(source));
  const bool table = options.format == "table";
  print(table ? table_of(compared) : json_of(compared));
  options.contests.finish_store(table);
  tell(freedom_note(entry.mice));
  if (compared.stopped) return exit_interrupted();
  tell(compared.never_started);
  return compared.never_started.empty() ? exit_good : exit_finding;
}

}  // namespace

void add_compare(Command& app, int& exit) {
  auto options = std::make_shared<CompareOptions>();
  Command* command = app.add_subcommand("compare", "Race mice against a first one until it is decided which is better");
  options->command = command;
  command->group(groups::mice);
  command
      ->add_option(
          "mice", options->mice,
          "The first mouse, and those that are compared with it: [NAME=]mouse[:key=value]..., or "
          "[NAME=]capstone:FILE, program:COMMAND, controller:COMMAND, firmware:FILE, mms:COMMAND, mouse:parts=COMMAND")
      ->type_name("SPEC")
      ->expected(1, 1000);
  add_mice_files(*command, options->mice_files);
  command->group("Test");
  command
      ->add_option("--better-by", options->test.better_by,
                   "The smallest difference that matters, in shares of the best possible score")
      ->check(in_range(least_better_by, most_better_by))
      ->capture_default_str();
  command->add_option("--alpha", options->test.alpha, "Largest probability of 'better' or 'worse' without a difference")
      ->check(in_range(0.000001, 0.5))
      ->capture_default_str();
  command
      ->add_option("--beta", options->test.beta,
                   "Largest probability of 'no difference' where there is one of --better-by or more")
      ->check(in_range(0.000001, 0.5))
      ->capture_default_str();
  command
      ->add_option("--test", options->method,
                   "bets: keeps these probabilities whatever the scores; gsprt: the test of chess engines, which needs "
                   "fewer contests and is approximate. The interval is that of bets")
      ->check(one_of({"bets", "gsprt"}))
      ->capture_default_str();
  command->add_option("--most", options->most, "The most mazes to race in")
      ->check(in_range(std::uint64_t{1}, std::uint64_t{most_pairs}))
      ->capture_default_str();
  add_mazes(*command, options->contests, "generated ones (named ones are drawn at random, with repetitions)");
  command->add_option("--generator", options->generated.kind, "Generator: " + list_of(all_generators()))
      ->type_name("KIND")
      ->capture_default_str();
  options->generated.add_to(*command);
  add_world_and_seed(*command, options->contests);
  add_program_options(*command, options->external_mice);
  command->group(groups::output);
  command->add_option("--format", options->format, "What is printed")
      ->check(one_of({"table", "json"}))
      ->capture_default_str();
  command->footer(
      "Example: labmouse compare flood flood:stride=1\n"
      "         labmouse compare old='program:./old' new='program:./new' --world physical --better-by 0.05");
  command->refer({groups::world, groups::contests, groups::programs}, "labmouse race");
  command->callback([options, &exit] { exit = compare(*options); });
}

}  // namespace labmouse::cli
