// A contest in seconds, held at once.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "labmouse/contest/drive.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/drive_choices.hpp"
#include "labmouse/lab/page/mouse_spec.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/plays/play_seconds.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

std::string too_large(const NamedMaze& maze) {
  const Size size = maze.maze.size();
  if (std::max(size.width, size.height) <= max_drive_side) return "";
  return fmt::format("{} is {}x{}; robots drive in mazes up to {}x{}", maze.name, size.width, size.height,
                     max_drive_side, max_drive_side);
}

}  // namespace

PageReply answer_drive(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const std::string spec = request.text("mouse");
  const NamedMaze maze = request.maze();
  const std::uint64_t seed = request.seed();
  if (!request.has("robot")) request.reject("'robot' is missing");
  const std::string rules_name = request.text("rules");
  request.reject(too_large(maze));
  if (!request.error().empty()) return failed(request.error());
  const SpecResult mice = read_page_mice({&spec, 1});
  if (!mice.error.empty()) return failed(mice.error);
  if (mice.contestants.size() != 1) return failed(fmt::format("'{}' names several mice; name exactly one", spec));
  const Contestant& mouse = mice.contestants.front();
  if (auto reason = refuse_to_drive(mice.contestants); !reason.empty()) return failed(std::move(reason));
  PageRobot robot = page_robot(json["robot"]);
  if (!robot.error.empty()) return failed(std::move(robot.error));
  std::optional<DriveRules> rules = page_rules(rules_name);
  if (!rules) return failed(fmt::format("the page has no rules '{}'", rules_name));
  DriveRecordFile file;
  file.maze_name = maze.name;
  file.maze = maze.maze;
  file.mouse = mouse.name;
  file.settings = settings_in_seconds(mouse);
  file.seed = seed;
  share_route_tables(robot.model);
  file.model = std::make_shared<DriveModel>(std::move(robot.model));
  file.rules = std::move(*rules);
  const auto strategy = mouse.strategy(maze.maze, brief(maze.maze, file.rules, *file.model, seed));
  file.record = drive(maze.maze, file.rules, *file.model, *strategy);
  return answered({{"play", play_json(file)}, {"record", write_drive_record(file)}});
}

}  // namespace labmouse
