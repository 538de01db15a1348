// labmouse inspect: describes mazes and checks them against the contest rules.
#include "labmouse/maze/inspect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "maps.hpp"

namespace labmouse::cli {
namespace {

struct InspectOptions {
  std::vector<std::string> mazes;
  std::string against;
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

std::string describe(const WallSet& walls) {
  constexpr int most = 10;
  std::string text = fmt::format("{}", walls.count());
  int shown_walls = 0;
  walls.for_each([&](Wall wall) {
    if (shown_walls < most)
      text +=
          fmt::format("{}{} of ({},{})", shown_walls == 0 ? ": " : ", ", name_of(wall.side), wall.cell.x, wall.cell.y);
    if (shown_walls++ == most) text += ", ...";
  });
  return text;
}

/// Compares maps, such as those that robots print, with the maze in which they were made.
int compare_all(const InspectOptions& options) {
  if (options.mazes.empty()) throw UsageError("error: --against compares maps with a maze; name the files of the maps");
  bool differs = false;
  for (const std::string& path : options.mazes) {
    const ComparedMap map = compare_map(path, options.against, options.places);
    print(
        fmt::format("{}, compared with {}\n  read as       {}\n  inner walls   {}: {} right, {} wrong, {} unseen\n"
                    "  false walls   {}\n  missed walls  {}\n",
                    shown(path), shown(map.truth.name), map.reading, map.walls(), map.right(), map.wrong(),
                    map.found.unseen.count(), describe(map.found.false_walls), describe(map.found.missed_walls)));
    differs |= map.wrong() > 0;
  }
  return options.check && differs ? exit_finding : exit_good;
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
  command->add_option("--against", options->against, "Compare the maps with this maze: false, missed and unseen walls")
      ->type_name("MAZE");
  command->add_flag("--check", options->check,
                    "Exit with 1 if a maze breaks a contest rule, or a map has a wrong wall");
  command->footer("Example: labmouse inspect contest-01 --check");
  command->callback(
      [options, &exit] { exit = options->against.empty() ? inspect_all(*options) : compare_all(*options); });
}

}  // namespace labmouse::cli
