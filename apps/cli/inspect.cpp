// labmouse inspect: what a maze is like, and whether it keeps the rules of the contests.
#include "labmouse/maze/inspect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse::cli {
namespace {

struct InspectOptions {
  std::vector<std::string> mazes;
  Places places;
  bool check = false;
};

std::string describe(const NamedMaze& maze, const Inspection& found) {
  const Size size = maze.maze.size();
  std::string text = shown(maze.name) + "\n";
  const auto line = [&](std::string_view what, const std::string& value) {
    text += fmt::format("  {:<36}{}\n", what, value);
  };
  if (!maze.reading.empty()) line("read as", maze.reading);
  line("size", fmt::format("{}x{}", size.width, size.height));
  line("reachable cells", fmt::format("{} of {}", found.reachable.count(), size.area()));
  line("dead ends", fmt::format("{}", found.dead_ends));
  line("junctions", fmt::format("{}", found.junctions));
  line("loops", fmt::format("{}", found.loops));
  line("shortest path in cells", found.shortest_cells ? fmt::format("{}", *found.shortest_cells) : "none");
  line("shortest run in steps", found.shortest_strides ? fmt::format("{}", found.shortest_strides->strides) : "none");
  line("different shortest runs", found.shortest_strides ? fmt::format("{}", found.shortest_strides->count) : "none");
  line("left wall follower", found.left_follower_arrives ? "arrives" : "does not arrive");
  line("right wall follower", found.right_follower_arrives ? "arrives" : "does not arrive");
  for (const RuleFinding& rule : found.contest_rules)
    line(fmt::format("contest rule: {}", rule.name), rule.passed ? "pass" : "FAIL: " + rule.reason);
  return text;
}

int inspect_all(const InspectOptions& options) {
  bool broken = false;
  for (const NamedMaze& maze : find_mazes(options.mazes, options.places).mazes) {
    const Inspection found = inspect(maze.maze);
    print(describe(maze, found));
    broken |= !std::all_of(found.contest_rules.begin(), found.contest_rules.end(),
                           [](const auto& rule) { return rule.passed; });
  }
  return options.check && broken ? exit_finding : exit_good;
}

}  // namespace

void add_inspect(Command& app, int& exit) {
  auto options = std::make_shared<InspectOptions>();
  Command* command = app.add_subcommand("inspect", "Describe mazes and check whether they follow the contest rules");
  command
      ->add_option("mazes", options->mazes,
                   "Maze files, folders, patterns or built-in mazes; default: all built-in mazes")
      ->type_name("MAZE");
  add_places(*command, options->places);
  command->add_flag("--check", options->check, "Exit with 1 if a maze breaks a contest rule");
  command->footer("Example: labmouse inspect contest-01 --check");
  command->callback([options, &exit] { exit = inspect_all(*options); });
}

}  // namespace labmouse::cli
