#include "labmouse/lab/records/mms_record.hpp"

#include "labmouse/external/mms/half_pose.hpp"
#include "labmouse/lab/records/mms_statistics_json.hpp"
#include "labmouse/lab/records/record_maze.hpp"
#include "labmouse/lab/system/version.hpp"

namespace labmouse {
namespace {

Json event_json(const MmsEvent& event) {
  Json json = {{"line", event.line}};
  if (!event.reply.empty()) json["reply"] = event.reply;
  json["place"] = Json{event.pose.place.x, event.pose.place.y};
  json["heading"] = name_of(event.pose.heading);
  json["clock"] = event.clock;
  return json;
}

Json end_json(const MmsRun& run) {
  return {{"outcome", name_of(run.outcome)},
          {"end", run.end},
          {"finished", run.statistics.finished},
          {"statistics", statistics_json(run.statistics)},
          {"lines", run.lines},
          {"invalid_lines", run.invalid_lines},
          {"log", run.log},
          {"errors", run.errors},
          {"clock", run.clock}};
}

}  // namespace

MmsRecorder::MmsRecorder(const std::string& mouse, const NamedMaze& maze, std::int64_t most) : most_(most) {
  text_ = record_line({{"labmouse", "mms record"},
                       {"format", 1},
                       {"version", version()},
                       {"maze", record_maze_json(maze.name, as_in_mms(maze.maze))},
                       {"mouse", {{"name", mouse}}}});
}

void MmsRecorder::add(const MmsEvent& event) {
  ++events_;
  // After the first omitted event all are omitted, so the written ones have no gap.
  if (written_ + 1 < events_ || written_ >= most_ || text_.size() >= most_recorded_bytes) return;
  text_ += record_line(event_json(event));
  ++written_;
}

std::string MmsRecorder::finish(const MmsRun& run) {
  if (events_ > written_) text_ += record_line({{"left_out", events_ - written_}});
  text_ += record_line(end_json(run));
  return std::move(text_);
}

}  // namespace labmouse
