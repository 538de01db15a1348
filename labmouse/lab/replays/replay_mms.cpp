// Records of programs for mms.
#include <fmt/format.h>

#include "labmouse/lab/pictures/mms_picture.hpp"
#include "labmouse/lab/replays/mms_drawing.hpp"
#include "labmouse/lab/replays/mms_replay.hpp"
#include "labmouse/lab/replays/mms_summary.hpp"
#include "labmouse/lab/replays/play.hpp"
#include "labmouse/lab/replays/replay.hpp"

namespace labmouse {
namespace {

class ReplayOfMms final : public Replay {
 public:
  ReplayOfMms(MmsRecordFile file, MmsReplay replay, std::string_view text)
      : file_(std::move(file)), replay_(std::move(replay)), maze_{file_.maze_name, *file_.maze}, text_(text) {}

  RecordSubject subject() const override { return {file_.mouse, maze_, std::nullopt}; }
  std::string text() const override { return text_; }
  Json packed() const override { return {{"mouse", file_.mouse}, {"maze", file_.maze_name}, {"mms", text_}}; }
  std::optional<RecordedWorld> world() const override { return std::nullopt; }
  Json play() const override { return play_json(file_); }
  std::string picture() const override { return draw_mms_run(file_.mouse, maze_, replay_.run, replay_.walk); }
  std::string summary(const TextDrawer& draw) const override {
    return mms_drawing_of(maze_.maze, replay_.run.canvas, replay_.run.pose, draw) +
           report_of(file_.mouse, maze_, replay_.run);
  }
  std::string result() const override { return mms_score_line(file_.mouse, maze_, replay_.run); }
  std::string reasons(int /*candidates*/) const override { return ""; }
  void animate(const TextDrawer& draw, const std::function<void(const std::string&)>& show) const override {
    HalfPose last;
    replay(file_, [&](std::size_t i, const MmsHost& host) {
      const RecordedMmsEvent& event = file_.events[i];
      // What is only drawn takes no time; it shows with the next move.
      if (event.pose == last) return;
      last = event.pose;
      show(mms_frame(maze_.maze, {event.line, event.reply, event.pose, event.clock}, host, draw));
    });
  }

  const LayerSet& layers() const override {
    static const LayerSet none;
    return none;
  }
  RecordDrawing drawing(const LayerSet& /*chosen*/, int /*step*/) const override {
    return {as_in_mms(maze_.maze), mms_layers(replay_.run.canvas, replay_.run.pose), result(), {}, ""};
  }
  void add_reasons(const Contestant& /*mouse*/) override {}

 private:
  MmsRecordFile file_;
  MmsReplay replay_;
  NamedMaze maze_;
  std::string text_;
};

OpenedRecord open_mms(std::string_view text, const NamedMaze* maze) {
  ReadMmsRecordResult read = read_mms_record(text);
  if (!read.file) return {nullptr, std::move(read.problems), ""};
  put_into(maze, *read.file);
  MmsReplay replay = replay_of(*read.file);
  if (!replay.disagreement.empty()) return {nullptr, {}, std::move(replay.disagreement)};
  return {std::make_unique<ReplayOfMms>(std::move(*read.file), std::move(replay), text), {}, ""};
}

OpenedRecord unpack_mms(const ReadJson& packed, const NamedMaze& /*maze*/) {
  if (!packed["mms"].is_string()) return {nullptr, {{0, 0, "'mms' is not a text"}}, ""};
  return open_mms(packed["mms"].get<std::string>(), nullptr);
}

}  // namespace

const RecordKind mms_records = {"mms record", "a record of mms", "mms", open_mms, unpack_mms};

}  // namespace labmouse
