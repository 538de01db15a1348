// Unpacks records of reports, and draws pictures.
#include <fmt/format.h>

#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/mouse_spec.hpp"
#include "labmouse/lab/page/page_world.hpp"
#include "labmouse/lab/page/played_record.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/pictures/picture_layers.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {
namespace {

/// Runs a built-in mouse again to add the reasons of its decisions, which are reproducible.
void add_reasons(Replay& replay) {
  const std::string spec = replay.subject().mouse;
  const SpecResult mice = read_page_mice({&spec, 1});
  if (mice.contestants.size() == 1) replay.add_reasons(mice.contestants.front());
}

std::string picture_of(const NamedMaze& maze) {
  DrawingLayers layers = layers_of(maze.maze, Rules(), {Layer::coordinates});
  layers.title = maze.name;
  return draw_svg(maze.maze, layers);
}

}  // namespace

PageReply answer_unpack(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const NamedMaze maze = request.maze();
  if (!request.has("record")) request.reject("'record' is missing");
  if (!request.error().empty()) return failed(request.error());
  const ReadJson& packed = json["record"];
  const RecordKind& kind = kind_of_packed(packed);
  OpenedRecord opened = kind.unpack(packed, maze);
  if (!opened.problems.empty())
    return failed(fmt::format("the report has {} that cannot be read", kind.name), std::move(opened.problems));
  const bool is_named = packed.contains("mouse") && packed["mouse"].is_string();
  const std::string name =
      fmt::format("the record of {} in {}", is_named ? packed["mouse"].get<std::string>() : "a mouse", maze.name);
  if (PageFailure failure = failure_of(name, opened); !failure.error.empty()) return {nullptr, "", std::move(failure)};
  add_reasons(*opened.replay);
  return answered({{"play", play_of(*opened.replay)}, {"record", opened.replay->text()}});
}

PageReply answer_picture(const ReadJson& json, std::string_view bytes) {
  PageRequest request(json);
  if (bytes.empty()) {
    const NamedMaze maze = request.maze();
    if (!request.error().empty()) return failed(request.error());
    return answered({{"svg", picture_of(maze)}});
  }
  OpenedRecord opened = kind_of_record(bytes).open(bytes, nullptr);
  if (PageFailure failure = failure_of("the record", opened); !failure.error.empty())
    return {nullptr, "", std::move(failure)};
  return answered({{"svg", opened.replay->picture()}});
}

}  // namespace labmouse
