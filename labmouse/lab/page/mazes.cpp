// Built-in and generated mazes, and properties of a maze.
#include <fmt/format.h>

#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/bounds/mms_bound.hpp"
#include "labmouse/lab/mazes/builtin_mazes.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/entrants.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/replays/fields.hpp"
#include "labmouse/lab/replays/maze_data.hpp"
#include "labmouse/lab/text/optional_json.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/maze/inspect.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {
namespace {

/// "contest-16x16-seed-7", with "-loops-N" for N thousandths of loops if N is not 0.
std::string name_of_made(const Generator& generator, const GeneratorOrder& order) {
  std::string name = fmt::format("{}-{}x{}-seed-{}", generator.name, order.size.width, order.size.height, order.seed);
  if (order.loops > 0) name += fmt::format("-loops-{}", order.loops);
  return name;
}

Json rules_json(const std::vector<RuleFinding>& findings) {
  Json rules = Json::array();
  for (const RuleFinding& rule : findings)
    rules.push_back({{"name", rule.name}, {"passed", rule.passed}, {"reason", rule.reason}});
  return rules;
}

Json inspection_json(const Maze& maze) {
  const Rules rules;
  const Inspection found = inspect(maze, rules.stride);
  const Bound bound = bound_of(maze, rules);
  const MmsBound mms = mms_bound_of(maze);
  const auto& strides = found.shortest_strides;
  return {{"optimum", or_null(bound.optimum)},
          {"bound", or_null(bound.score)},
          {"mms_run", or_null(mms.run)},
          {"mms_score", or_null(mms.score)},
          {"shortest_cells", or_null(found.shortest_cells)},
          {"shortest_runs", strides ? Json(strides->count) : Json(nullptr)},
          {"reachable", found.reachable.count()},
          {"dead_ends", found.dead_ends},
          {"junctions", found.junctions},
          {"loops", found.loops},
          {"left_follower_arrives", found.left_follower_arrives},
          {"right_follower_arrives", found.right_follower_arrives},
          {"contest_rules", rules_json(found.contest_rules)},
          {"route", route_json(maze, rules)},
          {"distances", distances_json(maze, rules.stride)}};
}

}  // namespace

PageReply answer_builtin_maze(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const std::string name = request.text("name");
  if (!request.error().empty()) return failed(request.error());
  for (const BuiltinMaze& builtin : builtin_mazes())
    if (builtin.name == name) return answered({{"maze", maze_data(name, *read_maze(builtin.text).maze)}});
  return failed(fmt::format("unknown built-in maze '{}'", name));
}

PageReply answer_make_maze(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const auto [generator, order] = read_generator(request);
  if (!request.error().empty()) return failed(request.error());
  return answered({{"maze", maze_data(name_of_made(*generator, order), generator->make(order))}});
}

PageReply answer_inspect(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const NamedMaze maze = request.maze();
  if (!request.error().empty()) return failed(request.error());
  return answered(inspection_json(maze.maze));
}

}  // namespace labmouse
