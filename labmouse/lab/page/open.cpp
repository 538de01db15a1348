// Opens a dropped file of any kind: a maze, a record, results of a race, or a robot.
#include <fmt/format.h>

#include "labmouse/functions/byte_order_mark.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/page_world.hpp"
#include "labmouse/lab/page/played_record.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/page/results.hpp"
#include "labmouse/lab/replays/maze_data.hpp"
#include "labmouse/lab/system/file_names.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/encoding.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_problem.hpp"
#include "labmouse/lab/text/markup.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {
namespace {

/// The text without byte order mark and leading white space.
std::string_view trimmed(std::string_view text) {
  text = without_mark(text);
  const auto first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

/// The beginning in lower case and without white space.
std::string gist(std::string_view text) {
  constexpr std::size_t most = 200;
  std::string gist;
  for (const char letter : text.substr(0, most))
    if (letter > ' ' || letter < 0)
      gist += static_cast<char>(letter >= 'A' && letter <= 'Z' ? letter + ('a' - 'A') : letter);
  return gist;
}

/// Whether the text is meant to be a record, even with a damaged first line.
bool is_record(std::string_view text) {
  const ReadJson json = read_json(text.substr(0, text.find('\n')));
  if (json.is_object() && json.contains("labmouse")) return json["labmouse"] == kind_of_record(text).header;
  return gist(text).starts_with("{\"labmouse\":\"") && gist(text).find("record\"") != std::string::npos;
}

PageReply open_markup(const std::string& name, std::string_view text) {
  const bool ours = text.find("labmouse") != std::string_view::npos && !first_tag(text).starts_with("<svg");
  return failed(ours ? fmt::format("{} is a labmouse page; open it in the browser, like any web page", name)
                     : fmt::format("{} is a web page or a picture; open mazes, records or race results here", name));
}

PageReply open_record(const std::string& name, std::string_view text, const std::optional<NamedMaze>& maze) {
  const RecordKind& kind = kind_of_record(text);
  OpenedRecord opened = kind.open(text, nullptr);
  if (opened.lacks_maze && maze) opened = kind.open(text, &*maze);
  if (PageFailure failure = failure_of(name, opened); !failure.error.empty()) return {nullptr, "", std::move(failure)};
  return answered({{"kind", "record"}, {"play", play_of(*opened.replay)}});
}

/// Text that names the version that wrote the results, if it is known and differs from this one.
std::string writer_of(const ReadJson& json) {
  if (!json.contains("labmouse") || !json["labmouse"].is_string() || json["labmouse"] == version()) return "";
  return fmt::format("; they were written by labmouse {}, and this is {}", json["labmouse"].get<std::string>(),
                     version());
}

PageReply open_results(const std::string& name, std::string_view text) {
  const ReadJson json = read_json(text);
  if (json.is_discarded()) return failed(fmt::format("{} is not valid JSON", name), {json_problem(text)});
  if (!json.is_object() || !(json.contains("groups") || json.contains("mice")))
    return failed(fmt::format("{} is JSON, but neither a record nor the results of a race", name));
  Json results;
  std::string error = read_results(json, results);
  if (!error.empty())
    return failed(fmt::format("{} holds race results that cannot be read{}", name, writer_of(json)),
                  {{0, 0, std::move(error)}});
  return answered({{"kind", "results"}, {"results", std::move(results)}});
}

PageReply open_maze(const std::string& name, ReadResult read) {
  if (!read.maze) return failed(fmt::format("{} is not a readable maze", name), std::move(read.problems));
  return answered({{"kind", "maze"}, {"maze", maze_data(name, *read.maze)}, {"notes", read.notes}});
}

/// Opens a robot without checks: the editor shows its errors.
PageReply open_robot(const std::string& name, std::string_view text) {
  return answered({{"kind", "robot"}, {"name", stem_of(name)}, {"text", text}});
}

}  // namespace

PageReply answer_open(const ReadJson& json, std::string_view bytes) {
  PageRequest request(json);
  const std::string name = request.text("name");
  std::optional<NamedMaze> maze;
  if (request.has("maze")) maze = request.maze();
  if (!request.error().empty()) return failed(request.error());
  const std::string_view text = trimmed(bytes);
  if (text.empty()) return failed(fmt::format("{} is empty", name));
  if (const auto foreign = foreign_encoding(bytes); !foreign.empty())
    return failed(fmt::format("{} {}", name, foreign));
  if (is_markup(text)) return open_markup(name, text);
  if (name.ends_with(".toml")) return open_robot(name, text);
  const ReadChoice choice{.closes_unseen = true};
  if (text.front() != '{' && text.front() != '[') return open_maze(name, read_maze(bytes, choice));
  if (is_too_deep(text))
    return failed(fmt::format("{} is JSON, but its lists and objects are nested too deeply", name));
  if (is_record(text)) return open_record(name, bytes, maze);
  if (ReadResult read = read_maze(bytes, choice); read.maze) return open_maze(name, std::move(read));
  return open_results(name, bytes);
}

}  // namespace labmouse
