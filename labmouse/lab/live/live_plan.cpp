#include "labmouse/lab/live/live_plan.hpp"

#include <fmt/format.h>

#include "labmouse/lab/records/drive_notation.hpp"
#include "labmouse/lab/routes/one_plan.hpp"

namespace labmouse {

LivePlanner::LivePlanner(const DriveModel& model) : model_(model), tables_(route_tables_of(model)) {}

LivePlan LivePlanner::plan(const PartialMap& map) const {
  const WallSet& hoped = map.known.open_walls();
  WallSet seen = hoped;
  seen -= map.unseen;
  return {fastest_route(map.known, seen, tables_), fastest_route(map.known, hoped, tables_).time};
}

std::string LivePlanner::text_of(const LivePlan& plan) const {
  if (plan.hope >= no_time) return "no route to a goal is possible";
  const double hope = plan.hope / 1e6, known = plan.known.time / 1e6;
  if (plan.known.time >= no_time) return fmt::format("no route to a goal is known; the best hope takes {:.3f} s", hope);
  if (!plan.is_certain()) return fmt::format("the known route takes {:.3f} s, the best hope {:.3f} s", known, hope);
  return fmt::format("the known route takes {:.3f} s, and no unseen wall can make it faster: time to return", known);
}

std::string LivePlanner::line_of(const LivePlan& plan) const {
  if (plan.known.time >= no_time) return "";
  const std::string line = "plan " + notation_of(plan.known, model_.tables);
  unsigned sum = ' ';
  for (const char letter : line) sum ^= static_cast<unsigned char>(letter);
  return fmt::format("{} *{:02x}\n", line, sum);
}

}  // namespace labmouse
