// Records of contests in steps.
#include <fmt/format.h>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/records/explanation.hpp"
#include "labmouse/lab/records/packed_record.hpp"
#include "labmouse/lab/replays/play.hpp"
#include "labmouse/lab/replays/replay.hpp"
#include "labmouse/lab/replays/steps_text.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

class StepsReplay final : public Replay {
 public:
  explicit StepsReplay(RecordFile file) : file_(std::move(file)) {}

  RecordSubject subject() const override { return {file_.mouse, {file_.maze_name, *file_.maze}, file_.seed}; }
  std::string text() const override { return write_record(file_); }
  Json packed() const override { return pack_record(file_); }
  std::optional<RecordedWorld> world() const override {
    Rules rules;
    rules.budget = file_.rules.budget;
    if (!file_.world.empty() || file_.rules != rules) return std::nullopt;
    return RecordedWorld{"steps", {{"budget", rules.budget}}};
  }
  Json play() const override { return play_json(file_); }
  std::string picture() const override { return picture_of(file_); }
  std::string summary(const TextDrawer& draw) const override {
    const std::string checked = checked_line(file_);
    return summary_of(file_, draw) + (checked.empty() ? "" : checked + "\n");
  }
  std::string result() const override { return result_line(file_) + "\n"; }
  std::string reasons(int candidates) const override { return explanation_of(file_, candidates); }
  void animate(const TextDrawer& draw, const std::function<void(const std::string&)>& show) const override {
    labmouse::animate(file_, draw, show);
  }

  const LayerSet& layers() const override { return all_layers(); }
  RecordDrawing drawing(const LayerSet& chosen, int step) const override {
    const auto steps = file_.run.steps.size();
    RecordDrawing drawing{*file_.maze, {}, "", {}, ""};
    if (step > static_cast<int>(steps)) {
      drawing.error = fmt::format("the record has only {} steps; there is no step {}", steps, step);
      return drawing;
    }
    const RecordFile file = step > 0 ? as_of(file_, step) : file_;
    drawing.layers = layers_of(file, chosen);
    drawing.layers.title =
        step > 0 ? fmt::format("{} in {}: step {} of {}", file.mouse, file.maze_name, step, steps) : title_of(file);
    drawing.line = step > 0 ? shown(drawing.layers.title) + "\n" : result();
    if (drawing.layers.route.empty()) drawing.missing[Layer::path] = "no speed run";
    if (!drawing.layers.candidates)
      drawing.missing[Layer::candidates] =
          step > 0 ? "no reasons up to that step"
                   : "no reasons; to keep them, use `labmouse run` with --explain and --record";
    return drawing;
  }

  void add_reasons(const Contestant& mouse) override {
    if (!refuse_to_walk(mouse).empty()) return;
    Briefing briefing = brief(*file_.maze, file_.rules, file_.seed);
    briefing.reasons = true;
    const auto strategy = mouse.strategy(*file_.maze, briefing);
    RunRecord again = run(*file_.maze, file_.rules, *strategy);
    if (again.steps == file_.run.steps) file_.run.reasons = std::move(again.reasons);
  }

 private:
  RecordFile file_;
};

/// Replays a record in its maze. Fields that a packed record leaves out on purpose count as if they were given.
OpenedRecord played_steps(RecordFile file, bool packed) {
  ReplayResult result = replay(file, *file.maze);
  if (!result.disagreement.empty()) return {nullptr, {}, std::move(result.disagreement)};
  file.run = std::move(result.run);
  if (packed) {
    file.given.clear();
    file.given_end = {};
  }
  return {std::make_unique<StepsReplay>(std::move(file)), {}, ""};
}

OpenedRecord open_steps(std::string_view text, const NamedMaze* maze) {
  ReadRecordResult read = read_record(text);
  if (!read.file) return {nullptr, std::move(read.problems), ""};
  put_into(maze, *read.file);
  if (!read.file->maze) return {nullptr, {{0, 0, "the record does not contain its maze"}}, "", true};
  return played_steps(std::move(*read.file), false);
}

OpenedRecord unpack_steps(const ReadJson& packed, const NamedMaze& maze) {
  UnpackResult unpacked = unpack_record(packed, maze.maze);
  if (!unpacked.file) return {nullptr, {{0, 0, std::move(unpacked.error)}}, ""};
  unpacked.file->maze_name = maze.name;
  return played_steps(std::move(*unpacked.file), true);
}

}  // namespace

const RecordKind steps_records = {"record", "a record in steps", "actions", open_steps, unpack_steps};

}  // namespace labmouse
