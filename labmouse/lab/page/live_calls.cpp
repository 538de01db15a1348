// The map of a real robot, whose bytes the page receives.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/live/live_map.hpp"
#include "labmouse/lab/live/live_plan.hpp"
#include "labmouse/lab/live/live_reader.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/page/robot_request.hpp"
#include "labmouse/lab/replays/maze_data.hpp"
#include "labmouse/lab/robots/robot_file.hpp"

namespace labmouse {
namespace {

/// The stream of a robot, and what it gives. Its size does not grow with the count of lines.
struct LiveStream {
  LiveStream(int stream_id, Size size, const std::optional<NamedMaze>& truth)
      : id(stream_id), reader(size), map(truth ? LiveMap(truth->maze) : LiveMap(size)) {}

  int id;
  LiveReader reader;
  LiveMap map;
  DriveModel model;                    ///< of the robot, if there is a planner
  std::optional<LivePlanner> planner;  ///< refers to the model
  std::optional<PartialMap> planned;   ///< the map of the last plan
  std::string advice, plan;            ///< in words, and as the line for the robot
};

/// The limit of streams, so that those that are never ended do not fill the memory; a new one replaces the oldest.
constexpr std::size_t most_streams = 4;
std::vector<std::unique_ptr<LiveStream>> streams;
int last_stream = 0;

LiveStream* find_stream(PageRequest& request) {
  const int id = request.whole("stream", 1, std::numeric_limits<int>::max());
  for (const auto& stream : streams)
    if (stream->id == id) return stream.get();
  request.reject("there is no such stream, or the core was started anew; connect again");
  return nullptr;
}

const char* kind_name(LiveFinding::Kind kind) {
  switch (kind) {
    case LiveFinding::Kind::restart:
      return "restart";
    case LiveFinding::Kind::outside:
      return "outside";
    case LiveFinding::Kind::open_border:
      return "open_border";
    case LiveFinding::Kind::contradiction:
      return "contradiction";
    case LiveFinding::Kind::false_wall:
      return "false_wall";
    case LiveFinding::Kind::missed_wall:
      break;
  }
  return "missed_wall";
}

Json finding_json(const LiveFinding& finding) {
  return {{"kind", kind_name(finding.kind)},
          {"line", finding.line},
          {"cell", finding.cell ? cell_json(*finding.cell) : Json()},
          {"side", finding.now ? Json(name_of(finding.now->side)) : Json()},
          {"words", words_of(finding)}};
}

Json findings_json(const std::vector<LiveFinding>& findings) {
  Json list = Json::array();
  for (const LiveFinding& finding : findings) list.push_back(finding_json(finding));
  return list;
}

/// The value of a field, if it is a number.
Json field_number(const LiveLine& line, std::string_view name) {
  for (const LiveField& field : line.fields)
    if (const ReadJson value = field.name == name ? read_json(field.value) : ReadJson(); value.is_number())
      return value.get<double>();
  return nullptr;
}

/// The walls of each cell: 1 for its north, 2 for its east.
Json sides_json(const WallSet& walls, Size size) {
  std::vector<unsigned> sides(static_cast<std::size_t>(size.area()));
  walls.for_each([&](Wall wall) {
    sides[static_cast<std::size_t>(size.index(wall.cell))] |= 1U << static_cast<unsigned>(wall.side);
  });
  return sides;
}

/// Plans if the map has changed.
void update_plan(LiveStream& stream, const PartialMap& map) {
  if (!stream.planner) return;
  if (stream.planned && stream.planned->known == map.known && stream.planned->unseen == map.unseen) return;
  stream.planned = map;
  const LivePlan plan = stream.planner->plan(map);
  stream.advice = stream.planner->text_of(plan);
  stream.plan = stream.planner->line_of(plan);
}

Json live_state(LiveStream& stream, const std::vector<LiveFinding>& findings, Json values) {
  const LiveMap& live = stream.map;
  const PartialMap map = live.map();
  update_plan(stream, map);
  Json route = Json::array(), fields = Json::object();
  for (const Pose& pose : live.route()) route.push_back(cell_json(pose.cell));
  for (const auto& [name, value] : live.fields()) fields[name] = value;
  Json pose;
  if (live.pose()) pose = {{"cell", cell_json(live.pose()->cell)}, {"heading", name_of(live.pose()->heading)}};
  return {{"stream", stream.id},
          {"maze", maze_data("", map.known)},
          {"unseen", sides_json(map.unseen, map.known.size())},
          {"drawing", write_partial_map(map).content.value_or("")},
          {"pose", std::move(pose)},
          {"route", std::move(route)},
          {"fields", std::move(fields)},
          {"values", std::move(values)},
          {"findings", findings_json(findings)},
          {"contradictions", findings_json(live.contradictions())},
          {"wrong", findings_json(live.wrong_walls())},
          {"advice", stream.advice},
          {"plan", stream.plan},
          {"lines", stream.reader.lines()},
          {"noise", stream.reader.noise()},
          {"restarts", live.restarts()}};
}

/// Reads the robot, if the request has one, for the plans of a stream.
PageReply set_planner(PageRequest& request, std::string_view bytes, Size size, LiveStream& stream) {
  const std::string name = request.text("robot");
  const std::string text = robot_text_of(request, bytes);
  if (size.width > max_drive_side || size.height > max_drive_side)
    request.reject(fmt::format("the page plans in mazes up to {}x{}", max_drive_side, max_drive_side));
  if (!request.error().empty()) return failed(request.error());
  RobotResult robot = read_robot(text, name);
  if (!robot.robot) return failed("the robot is refused", robot.problems);
  stream.model = std::move(robot.model);
  stream.planner.emplace(stream.model);
  return {};
}

}  // namespace

PageReply answer_live_begin(const ReadJson& json, std::string_view bytes) {
  PageRequest request(json);
  std::optional<NamedMaze> truth;
  if (request.has("maze")) truth = request.maze();
  const Size size =
      truth ? truth->maze.size() : Size{request.whole("width", 1, max_side), request.whole("height", 1, max_side)};
  if (!request.error().empty()) return failed(request.error());
  auto stream = std::make_unique<LiveStream>(last_stream + 1, size, truth);
  if (request.has("robot"))
    if (PageReply reply = set_planner(request, bytes, size, *stream); !reply.failure.error.empty()) return reply;
  ++last_stream;
  if (streams.size() == most_streams) streams.erase(streams.begin());
  streams.push_back(std::move(stream));
  return answered(live_state(*streams.back(), {}, Json::array()));
}

PageReply answer_live_feed(const ReadJson& json, std::string_view bytes) {
  PageRequest request(json);
  LiveStream* stream = find_stream(request);
  if (!request.error().empty()) return failed(request.error());
  std::vector<LiveFinding> findings;
  Json values = Json::array();
  for (const LiveLine& line : stream->reader.feed(bytes)) {
    for (const LiveFinding& finding : stream->map.add(line)) findings.push_back(finding);
    Json speed = field_number(line, "v"), battery = field_number(line, "batt");
    if (!(speed.is_null() && battery.is_null()))
      values.push_back({{"line", line.number}, {"v", std::move(speed)}, {"batt", std::move(battery)}});
  }
  return answered(live_state(*stream, findings, std::move(values)));
}

PageReply answer_live_end(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const LiveStream* stream = find_stream(request);
  if (!request.error().empty()) return failed(request.error());
  std::erase_if(streams, [&](const auto& each) { return each.get() == stream; });
  return answered(Json::object());
}

}  // namespace labmouse
