#include <fmt/format.h>

#include <limits>

#include "labmouse/external/mms/outcome.hpp"
#include "labmouse/lab/records/mms_record_file.hpp"

namespace labmouse {
namespace {

/// A reply of mms and a pose, in words: "ack at [1,3] heading north".
std::string words_of(std::string_view reply, const HalfPose& pose) {
  return fmt::format("{} at [{},{}] heading {}", reply.empty() ? "no reply" : reply, pose.place.x, pose.place.y,
                     name_of(pose.heading));
}

/// The first statistic that differs, in words; empty where none does.
std::string compare(const MmsStatistics& was, const MmsStatistics& is) {
  for (const MmsStatistic& statistic : mms_statistics)
    if (const float recorded = was.*statistic.value, played = is.*statistic.value; recorded != played)
      return fmt::format("the record ends with {} {}; replayed, it is {}", statistic.name, recorded, played);
  return was.finished == is.finished ? ""
                                     : "the record and the simulator disagree on whether the mouse was in the goal";
}

/// The replayed result of one event, as a record stores it.
struct Played {
  bool any = false;
  std::string reply;
  HalfPose pose;
};

}  // namespace

std::string replay(const MmsRecordFile& file, const std::function<void(std::size_t event, const MmsHost&)>& after) {
  // The limits of the original run do not matter: all these lines came before a limit ended it.
  MmsHost host(*file.maze, {.most_seconds = std::numeric_limits<int>::max()});
  Played played;
  host.on_event([&](const MmsEvent& event) { played = {true, std::string(event.reply), event.pose}; });
  std::string replies;
  for (std::size_t i = 0; i < file.events.size(); ++i) {
    const RecordedMmsEvent& event = file.events[i];
    played = {};
    replies.clear();
    host.obey(event.line, replies);
    if (!played.any)
      return fmt::format("event {}: in this maze its line neither moves the mouse nor draws anything", i + 1);
    if (played.reply != event.reply || played.pose != event.pose)
      return fmt::format("event {}: recorded {}; replayed {}", i + 1, words_of(event.reply, event.pose),
                         words_of(played.reply, played.pose));
    after(i, host);
  }
  if (!file.end || file.left_out > 0) return "";
  const bool at_best_run = file.end->outcome == name_of(MmsOutcome::never_ended);
  return compare(file.end->statistics, at_best_run ? host.ledger().at_best_run() : host.statistics());
}

}  // namespace labmouse
