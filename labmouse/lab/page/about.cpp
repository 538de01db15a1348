// What the core brings, and how fast it is.
#include <fmt/format.h>

#include <map>

#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/bench/distance_speed.hpp"
#include "labmouse/lab/bench/signature.hpp"
#include "labmouse/lab/bench/speed_json.hpp"
#include "labmouse/lab/mazes/builtin_mazes.hpp"
#include "labmouse/lab/mice/mice_json.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/drive_choices.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

template <class Things>
Json named(const Things& things) {
  Json list = Json::array();
  for (const auto* thing : things) list.push_back({{"name", thing->name}, {"summary", thing->summary}});
  return list;
}

/// The roster, with types of parameters in one word each.
Json mice() {
  const std::map<std::string, std::string> types = {{"whole number", "whole"}, {"number", "real"}, {"yes/no", "flag"}};
  Json list = mice_json();
  for (Json& mouse : list) {
    mouse["drives"] = find_mouse(mouse["name"].get<std::string>())->drives;
    for (Json& parameter : mouse["parameters"])
      if (const auto type = types.find(parameter["type"].get<std::string>()); type != types.end())
        parameter["type"] = type->second;
  }
  return list;
}

Json mazes() {
  Json list = Json::array();
  for (const BuiltinMaze& builtin : builtin_mazes()) {
    const Size size = read_maze(builtin.text).maze->size();
    list.push_back({{"name", builtin.name}, {"width", size.width}, {"height", size.height}});
  }
  return list;
}

Json rules_of_capstone() {
  const Rules rules;
  return {{"budget", rules.budget},
          {"exploration_factor", rules.exploration_factor},
          {"stride", rules.stride},
          {"failure_score", rules.failure_score}};
}

}  // namespace

PageReply answer_about(const ReadJson&, std::string_view) {
  return answered({{"version", version()},
                   {"compiler", compiler()},
                   {"mice", mice()},
                   {"mazes", mazes()},
                   {"formats", named(all_formats())},
                   {"generators", named(all_generators())},
                   {"rules", rules_of_capstone()},
                   {"most_side", max_side},
                   {"robots", page_robots_json()},
                   {"robot_keys", page_robot_keys_json()},
                   {"drive_rules", page_rules_json()}});
}

PageReply answer_signature(const ReadJson&, std::string_view) { return answered({{"signature", signature()}}); }

PageReply answer_speed(const ReadJson&, std::string_view) {
  return answered({{"distance_ns", distance_json(measure_distances())}});
}

}  // namespace labmouse
