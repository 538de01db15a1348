// Packed records, and pictures.
#include <fmt/format.h>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/mouse_spec.hpp"
#include "labmouse/lab/page/played_record.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/pictures/picture_layers.hpp"
#include "labmouse/lab/plays/play.hpp"
#include "labmouse/lab/plays/play_seconds.hpp"
#include "labmouse/lab/records/mms_record_file.hpp"
#include "labmouse/lab/records/packed_record.hpp"
#include "labmouse/lab/steps/steps_files.hpp"

namespace labmouse {
namespace {

/// The reasons of a mouse of the roster, which does the same when it runs again; none where it does not.
std::vector<StepReasons> reasons_again(const RecordFile& file) {
  const SpecResult mice = read_page_mice({&file.mouse, 1});
  if (mice.contestants.size() != 1 || !refuse_to_walk(mice.contestants.front()).empty()) return {};
  const auto mind = mice.contestants.front().make(*file.maze, file.rules, file.seed);
  mind->keep_reasons();
  RunRecord again = run(*file.maze, file.rules, *mind);
  return again.steps == file.run.steps ? std::move(again.reasons) : std::vector<StepReasons>();
}

/// A record of mms stands in a report as it is.
PageReply unpack_mms(const ReadJson& text) {
  ReadMmsRecordResult read = read_mms_record(text.get<std::string>());
  if (!read.file) return failed("the report has an mms record that cannot be read", std::move(read.problems));
  PlayResult result = play_json(*read.file);
  if (!result.disagreement.empty()) return disagreed("the record", std::move(result.disagreement));
  return answered({{"play", std::move(result.play)}, {"record", text}});
}

/// So does a record in seconds.
PageReply unpack_drive(const ReadJson& text) {
  ReadDriveRecordResult read = read_drive_record(text.get<std::string>());
  if (!read.file) return failed("the report has a record in seconds that cannot be read", std::move(read.problems));
  if (std::string disagreement = replay(*read.file); !disagreement.empty())
    return disagreed("the record", std::move(disagreement));
  return answered({{"play", play_json(*read.file)}, {"record", text}});
}

std::string picture_of(const NamedMaze& maze) {
  DrawingLayers layers = layers_of(maze.maze, Rules(), {Layer::coordinates});
  layers.title = maze.name;
  return draw_svg(maze.maze, layers);
}

PageReply drive_picture(std::string_view text) {
  ReadDriveRecordResult read = read_drive_record(text);
  if (!read.file) return failed("the record cannot be read", std::move(read.problems));
  if (std::string disagreement = replay(*read.file); !disagreement.empty())
    return disagreed("the record", std::move(disagreement));
  return answered({{"svg", draw_contest(*read.file)}});
}

}  // namespace

PageReply answer_unpack(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const NamedMaze maze = request.maze();
  if (!request.has("record")) request.reject("'record' is missing");
  if (!request.error().empty()) return failed(request.error());
  if (json["record"].is_object() && json["record"].value("mms", ReadJson()).is_string())
    return unpack_mms(json["record"]["mms"]);
  if (json["record"].is_object() && json["record"].value("drive", ReadJson()).is_string())
    return unpack_drive(json["record"]["drive"]);
  UnpackResult unpacked = unpack_record(json["record"], maze.maze);
  if (!unpacked.file) return failed("the report has a record that cannot be read", {{0, 0, std::move(unpacked.error)}});
  unpacked.file->maze = maze.maze;
  unpacked.file->maze_name = maze.name;
  const std::string name = fmt::format("the record of {} in {}", unpacked.file->mouse, maze.name);
  PlayedRecord record = played(name, std::move(*unpacked.file));
  if (!record.file) return {nullptr, "", std::move(record.failure)};
  // What was left out of it was never in doubt.
  record.file->given.clear();
  record.file->given_end = {};
  record.file->run.reasons = reasons_again(*record.file);
  return answered({{"play", play_json(*record.file)}, {"record", write_record(*record.file)}});
}

PageReply answer_picture(const ReadJson& json, std::string_view bytes) {
  PageRequest request(json);
  if (bytes.empty()) {
    const NamedMaze maze = request.maze();
    if (!request.error().empty()) return failed(request.error());
    return answered({{"svg", picture_of(maze)}});
  }
  if (is_drive_record(bytes)) return drive_picture(bytes);
  PlayedRecord record = read_played("the record", bytes);
  if (!record.file) return {nullptr, "", std::move(record.failure)};
  return answered({{"svg", labmouse::picture_of(*record.file)}});
}

}  // namespace labmouse
