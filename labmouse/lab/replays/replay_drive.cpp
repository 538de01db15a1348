// Records of contests in which robots drive.
#include <fmt/format.h>

#include "labmouse/lab/failure_rates/physical_settings.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/races/value_json.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/records/drive_story.hpp"
#include "labmouse/lab/replays/play_seconds.hpp"
#include "labmouse/lab/replays/replay.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {
namespace {

/// The maze as the mouse knew it at a time of the contest, and where it was.
class Scene {
 public:
  explicit Scene(const DriveRecordFile& file) : file_(file), unknown_(Knowledge(file.maze->size()).unknown()) {
    pose_ = {file.maze->start(), file.maze->start_heading()};
  }

  /// Goes on to a later time.
  void advance(MazeTime time, const Pose& pose) {
    const auto& walls = file_.record.walls;
    for (; wall_ < walls.size() && walls[wall_].time <= time; ++wall_) unknown_.erase(walls[wall_].wall);
    pose_ = pose;
  }

  DrawingLayers layers() const {
    DrawingLayers layers;
    layers.coordinates = true;
    layers.unknown = unknown_;
    layers.mouse = pose_;
    return layers;
  }

 private:
  const DriveRecordFile& file_;
  WallSet unknown_;
  std::size_t wall_ = 0;
  Pose pose_;
};

/// Calls `at(run, time, pose)` for each place that the mouse came to, in order.
template <class At>
void for_each_place(const DriveRecord& record, At at) {
  for (const DriveRun& run : record.runs) {
    for (const SearchMove& move : run.moves) at(run, move.end, move.to);
    for (const DriveSegment& segment : run.route.segments)
      if (const MazeTime time = run.begin + static_cast<MazeTime>(segment.end); time <= run.end)
        at(run, time, Pose{segment.to.cell, segment.to.heading});
  }
}

/// Whether conditions differ from those of a world only in its settings.
bool is_of_world(const PhysicalConditions& conditions) {
  const PhysicalConditions usual;
  return conditions.errors.causes == usual.errors.causes && conditions.handling == usual.handling &&
         conditions.controller.corrections == usual.controller.corrections;
}

class DriveReplay final : public Replay {
 public:
  DriveReplay(DriveRecordFile file, std::string_view text) : file_(std::move(file)), text_(text) {}

  RecordSubject subject() const override { return {file_.mouse, {file_.maze_name, *file_.maze}, file_.seed}; }
  std::string text() const override { return text_; }
  Json packed() const override {
    Json json = {{"mouse", file_.mouse}, {"maze", file_.maze_name}, {"seed", file_.seed}, {"drive", text_}};
    if (!has_trace(file_)) return json;
    // The trace is left out: it can be had again by running the contest again.
    DriveRecordFile file = file_;
    file.physical->notes.trace.clear();
    file.physical->conditions.trace_every = 0;
    json["drive"] = write_drive_record(file);
    return json;
  }
  std::optional<RecordedWorld> world() const override {
    if (!file_.added_world.empty()) return std::nullopt;
    const auto parts = file_.physical ? RobotParts::with_body : RobotParts::limits;
    Json conditions = {{"robot", robot_json(file_.model->robot, parts)}, {"rules", rules_json(file_.rules)}};
    if (!file_.physical) return RecordedWorld{world_of(file_), std::move(conditions)};
    const PhysicalPart& part = *file_.physical;
    const bool by_failure_model = part.notes.by_failure_model;
    if (part.edition != (by_failure_model ? failures_edition : physical_edition) || part.notes.foreign_parts)
      return std::nullopt;
    if (!is_of_world(part.conditions)) return std::nullopt;
    for (const Condition& each : conditions_of(physical_rows, part.conditions))
      conditions[each.key] = json_of(each.value);
    if (by_failure_model) {
      conditions["failure_rates"] = part.failure_rates;
      conditions["failure_rates_hash"] = part.rates_hash;
    }
    return RecordedWorld{world_of(file_), std::move(conditions)};
  }
  Json play() const override { return play_json(file_); }
  std::string picture() const override { return draw_contest(file_); }
  std::string summary(const TextDrawer& /*draw*/) const override { return summary_of(file_); }
  std::string result() const override { return result_line(file_) + "\n"; }
  std::string reasons(int /*candidates*/) const override { return story_of(file_); }
  void animate(const TextDrawer& draw, const std::function<void(const std::string&)>& show) const override {
    Scene scene(file_);
    for_each_place(file_.record, [&](const DriveRun& run, MazeTime time, const Pose& pose) {
      scene.advance(time, pose);
      show(fmt::format("{}{:>9.3f} s  {}  at ({},{}) heading {}\n", draw(*file_.maze, scene.layers()), in_seconds(time),
                       name_of(run.kind), pose.cell.x, pose.cell.y, name_of(pose.heading)));
    });
  }

  const LayerSet& layers() const override {
    static const LayerSet none;
    return none;
  }
  RecordDrawing drawing(const LayerSet& /*chosen*/, int /*step*/) const override {
    Scene scene(file_);
    for_each_place(file_.record, [&](const DriveRun&, MazeTime time, const Pose& pose) { scene.advance(time, pose); });
    return {*file_.maze, scene.layers(), result(), {}, ""};
  }
  void add_reasons(const Contestant& /*mouse*/) override {}

 private:
  DriveRecordFile file_;
  std::string text_;
};

OpenedRecord open_drive(std::string_view text, const NamedMaze* maze) {
  ReadDriveRecordResult read = read_drive_record(text);
  if (!read.file) return {nullptr, std::move(read.problems), ""};
  put_into(maze, *read.file);
  if (std::string disagreement = replay(*read.file); !disagreement.empty())
    return {nullptr, {}, std::move(disagreement)};
  return {std::make_unique<DriveReplay>(std::move(*read.file), text), {}, ""};
}

OpenedRecord unpack_drive(const ReadJson& packed, const NamedMaze& /*maze*/) {
  if (!packed["drive"].is_string()) return {nullptr, {{0, 0, "'drive' is not a text"}}, ""};
  return open_drive(packed["drive"].get<std::string>(), nullptr);
}

}  // namespace

std::unique_ptr<Replay> fresh_drive_replay(std::string_view text) {
  ReadDriveRecordResult read = read_drive_record(text);
  return read.file ? std::make_unique<DriveReplay>(std::move(*read.file), text) : nullptr;
}

const RecordKind drive_records = {"drive record", "a record in seconds", "drive", open_drive, unpack_drive};

}  // namespace labmouse
