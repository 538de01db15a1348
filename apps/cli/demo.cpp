// labmouse demo: a race and its page, for the first look.
#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <system_error>

#include "command.hpp"
#include "contests.hpp"
#include "embedded_page.hpp"
#include "labmouse/external/command_line.hpp"
#include "labmouse/lab/reports/race_page.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/system/calls.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "page.hpp"

namespace labmouse::cli {
namespace {

/// From the best to the worst: the best strategy, two that look at less of the maze, and a wall follower.
const std::vector<std::string> shown_mice = {"ariadne", "certify", "flood", "wall-left"};

constexpr const char* without_page =
    "This program was built without the page, which replays each contest: run `make page`, then `make race`, in the "
    "source folder.\n";

struct HeldRace {
  Race race;
  std::vector<std::string> records;
};

HeldRace hold_demo(std::vector<Contestant> mice) {
  Contests contests;
  std::vector<Entry> entries = contests.world.enter(std::move(mice));
  MazeCollection mazes = find_mazes_of(entries.front(), contests);
  Progress progress;
  Interruptible interruptible;
  const RaceOrder order = contests.order_in(entries.front().world);
  const std::size_t all = contests_of(entries.front().mice, mazes.mazes.size(), order);
  HeldRace held;
  RaceHooks hooks;
  hooks.stop = &interruptible.stopped();
  hooks.keep = [](const ContestResult&) { return Keep{.record = true}; };
  hooks.finished = [&](const Race& race, const ContestResult& contest, const ContestOutput& output) {
    progress.advance(all);
    held.records.resize(race.results.size());
    held.records[static_cast<std::size_t>(&contest - race.results.data())] = output.record;
  };
  held.race = hold_race(std::move(entries.front().mice), std::move(mazes.mazes), order, hooks);
  return held;
}

/// The program that shows a page to the user; empty where there is none, or no screen for it.
std::string browser() {
  const auto has = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  if (has("BROWSER")) return program_path(std::getenv("BROWSER"), "");
  return has("DISPLAY") || has("WAYLAND_DISPLAY") ? program_path("xdg-open", "") : "";
}

struct DemoOptions {
  std::string out = "labmouse-demo.html", page;
  bool stays = false;
};

int demo(const DemoOptions& options) {
  const bool has_page = !options.page.empty() || !embedded_page().empty();
  const std::string page = has_page ? find_page(options.page) : "";
  if (has_page) expect_outputs({{"--page", options.page}, {"--out", options.out, FileKind::page}});
  const HeldRace held = hold_demo(find_contestants(shown_mice));
  if (held.race.stopped) return exit_interrupted();
  print(
      fmt::format("{} mice explore {} mazes, return to the start, and run to the goal. Fewer steps are better.\n\n{}\n",
                  held.race.mice.size(), held.race.mazes.size(), table_of(held.race, colours(), false)));
  if (!has_page) {
    print(without_page);
    return exit_good;
  }
  save(options.out, race_page(held.race, held.records, page));
  const std::string opener = options.stays ? "" : browser();
  print(fmt::format("The page {} replays each contest{}.\n", shown(options.out),
                    opener.empty() ? ": open it in a browser" : "; a browser opens it now"));
  if (opener.empty()) return exit_good;
  const int failure = become_program({opener, options.out}, {});
  throw UsageError(fmt::format("error: {} does not start: {}; open {} in a browser yourself", opener,
                               std::generic_category().message(failure), options.out));
}

}  // namespace

void add_demo(Command& app, int& exit) {
  auto options = std::make_shared<DemoOptions>();
  Command* command = app.add_subcommand("demo", "Race four mice, and open the page with their replays");
  command->add_option("-o,--out", options->out, "File to write")->type_name("FILE")->capture_default_str();
  command->add_option("--page", options->page, "Use this page instead of the built-in one")->type_name("FILE");
  command->add_flag("--no-browser", options->stays, "Write the page, but do not open it");
  command->footer(
      "The page opens with the program in BROWSER, or else with xdg-open where there is a screen.\n\n"
      "Example: labmouse demo");
  command->callback([options, &exit] { exit = demo(*options); });
}

}  // namespace labmouse::cli
