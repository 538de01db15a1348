// Mazes as files and as links.
#include <fmt/format.h>

#include "labmouse/lab/mazes/maze_link.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/replays/maze_data.hpp"
#include "labmouse/lab/system/file_names.hpp"

namespace labmouse {
namespace {

std::string file_name(const std::string& maze, const Format& format) {
  return fmt::format("{}{}", file_names({stem_of(maze)}).front(), format.extension);
}

/// A binary file as a list of its bytes.
Json bytes_json(std::string_view content) {
  auto bytes = Json::array();
  for (const char byte : content) bytes.push_back(static_cast<unsigned char>(byte));
  return bytes;
}

}  // namespace

PageReply answer_write_maze(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const NamedMaze maze = request.maze();
  const std::string name = request.text("format");
  if (!request.error().empty()) return failed(request.error());
  const Format* format = find_format(name);
  if (format == nullptr) return failed(fmt::format("unknown format '{}'", name));
  const WriteResult written = format->write(maze.maze);
  if (!written.content) return failed(fmt::format("the format {} cannot hold this maze: {}", name, written.reason));
  Json answer = {{"file_name", file_name(maze.name, *format)}};
  if (format->name == maz_format.name)
    answer["bytes"] = bytes_json(*written.content);
  else
    answer["text"] = *written.content;
  return answered(std::move(answer));
}

PageReply answer_link(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const NamedMaze maze = request.maze();
  if (!request.error().empty()) return failed(request.error());
  return answered({{"link", link_of(maze)}});
}

PageReply answer_read_link(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const std::string link = request.text("link");
  if (!request.error().empty()) return failed(request.error());
  ReadLinkResult read = read_link(link);
  if (!read.maze) return failed("the link does not contain a maze", {{0, 0, std::move(read.error)}});
  return answered({{"maze", maze_data(read.maze->name, read.maze->maze)}});
}

}  // namespace labmouse
