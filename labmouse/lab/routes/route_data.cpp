#include "labmouse/lab/routes/route_data.hpp"

#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/routes/route_report.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/mouse/robot/drive_profile.hpp"

namespace labmouse {
namespace {

Json segment_json(const DriveRoute& route, std::size_t i, const DriveModel& model) {
  const DriveSegment& segment = route.segments[i];
  const DriveProfile profile(model, route, i);
  return {{"piece", notation_of(segment, model.tables)},
          {"from", node_json(segment.from)},
          {"to", node_json(segment.to)},
          {"begin_us", segment.begin},
          {"end_us", segment.end},
          {"speed_in", profile.speed_at(0)},
          {"speed_out", profile.speed_at(profile.duration())}};
}

}  // namespace

Json route_json(const RouteReport& report, const std::string& maze, const DriveModel& model) {
  Json json = {{"name", maze}};
  if (!report.error.empty()) {
    json["error"] = report.error;
    return json;
  }
  json["time_us"] = report.route.time;
  json["gate_to_gate_us"] = report.gate_to_gate;
  json["without_diagonals_us"] = time_json(report.without_diagonals);
  json["diagonal_gain"] = or_null(report.gain_over(report.without_diagonals));
  json["small_turns_us"] = time_json(report.small_turns);
  json["gain_over_small_turns"] = or_null(report.gain_over(report.small_turns));
  json["cells"] = report.cells;
  json["fewest_cells"] = report.fewest_cells;
  json["fewest_cells_us"] = report.fewest_cells_time ? Json(*report.fewest_cells_time) : Json(nullptr);
  json["route"] = notation_of(report.route, model.tables);
  json["segments"] = Json::array();
  for (std::size_t i = 0; i < report.route.segments.size(); ++i)
    json["segments"].push_back(segment_json(report.route, i, model));
  return json;
}

std::string json_of(const std::vector<RouteReport>& reports, const std::vector<NamedMaze>& mazes,
                    const DriveModel& model) {
  Json json = {{"labmouse", version()},
               {"robot", model.robot.name},
               {"cell", model.tables.cell},
               {"tables", hash_text(model.tables.hash)}};
  json["mazes"] = Json::array();
  for (std::size_t i = 0; i < reports.size(); ++i)
    json["mazes"].push_back(route_json(reports[i], mazes[i].name, model));
  return text_of(json);
}

}  // namespace labmouse
