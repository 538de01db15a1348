#include "labmouse/lab/reports/report_results.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/races/earlier_results.hpp"
#include "labmouse/lab/reports/file_kind.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_problem.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {
namespace {

constexpr const char* how_to_make = "create one with `labmouse race --format json` or `--out`";

/// Reads values and remembers the first one that is missing or wrong; returns an empty value in its place.
class ResultReading {
 public:
  const std::string& error() const { return error_; }

  std::string text(const Json& json, const char* key, const std::string& path) {
    const Json& value = get(json, key, path);
    if (value.is_string()) return value.get<std::string>();
    wrong(path, key, "is not a string");
    return "";
  }
  std::uint64_t number(const Json& json, const char* key, const std::string& path) {
    const Json& value = get(json, key, path);
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    wrong(path, key, "is not a whole number of 0 or more");
    return 0;
  }
  const Json& list(const Json& json, const char* key, const std::string& path) {
    static const Json none = Json::array();
    const Json& value = get(json, key, path);
    if (value.is_array()) return value;
    wrong(path, key, "is not a list");
    return none;
  }

  void refuse(const std::string& path, const char* key, const char* reason) { wrong(path, key, reason); }

 private:
  const Json& get(const Json& json, const char* key, const std::string& path) {
    static const Json nothing;
    if (json.is_object() && json.contains(key)) return json[key];
    wrong(path, key, "is missing");
    return nothing;
  }
  void wrong(const std::string& path, const char* key, const char* reason) {
    if (error_.empty())
      error_ = fmt::format("is not the JSON of a race: '{}{}' {}; {}", path, key, reason, how_to_make);
  }

  std::string error_;
};

ReportMouse read_mouse(const Json& json, const std::string& path, ResultReading& reading) {
  ReportMouse mouse;
  mouse.name = reading.text(json, "name", path);
  int number = 0;
  for (const Json& result : reading.list(json, "results", path)) {
    const std::string place = fmt::format("{}results[{}].", path, number++);
    auto& known = mouse.seeds[reading.text(result, "maze", place)];
    if (result.is_object() && result.contains("seed")) known.insert(reading.number(result, "seed", place));
  }
  return mouse;
}

ReportMaze read_raced_maze(const Json& json, const std::string& path, ResultReading& reading) {
  ReportMaze maze;
  maze.name = reading.text(json, "name", path);
  const auto side = [&](const char* key) {
    return static_cast<int>(std::min<std::uint64_t>(reading.number(json, key, path), max_side + 1));
  };
  maze.size = {side("width"), side("height")};
  if (json.is_object() && json.contains("optimum") && json["optimum"].is_number_unsigned())
    maze.optimum = json["optimum"].get<int>();
  return maze;
}

ReportWorld read_world(const Json& json, const WorldEntry* entry, const std::string& path, ResultReading& reading) {
  ReportWorld world;
  world.entry = entry;
  for (const Json& maze : reading.list(json, "mazes", path))
    world.mazes.push_back(read_raced_maze(maze, fmt::format("{}mazes[{}].", path, world.mazes.size()), reading));
  for (const Json& mouse : reading.list(json, "mice", path))
    world.mice.push_back(read_mouse(mouse, fmt::format("{}mice[{}].", path, world.mice.size()), reading));
  return world;
}

std::vector<ReportWorld> read_worlds(const Json& json, ResultReading& reading) {
  std::vector<ReportWorld> worlds;
  for (const Json& group : reading.list(json, "groups", "")) {
    const std::string path = fmt::format("groups[{}].", worlds.size());
    const WorldEntry* entry = find_world(reading.text(group, "world", path));
    if (entry == nullptr) reading.refuse(path, "world", "is a world that this version does not know");
    worlds.push_back(read_world(group, entry, path, reading));
  }
  return worlds;
}

/// The kind of a text that is not results, in words; empty where it is unknown.
std::string what_it_is(std::string_view text) {
  switch (kind_of_file(text)) {
    case FileKind::record:
      return "this is the record of one contest, not a race; `labmouse show --record` draws it";
    case FileKind::csv:
      return fmt::format("this is the CSV of a race, which does not hold enough; {}", how_to_make);
    case FileKind::page:
      return "this is already a page";
    case FileKind::maze:
      return "this is a maze, not a race; `labmouse show` draws it";
    default:
      return "";
  }
}

}  // namespace

ReadResultsResult read_report_results(std::string_view text) {
  if (std::string other = what_it_is(text); !other.empty()) return {std::nullopt, Problem{0, 0, std::move(other)}};
  const Json json = with_groups(read_ordered_json(text));
  if (json.is_discarded()) return {std::nullopt, json_problem(text)};
  ResultReading reading;
  reading.text(json, "labmouse", "");
  ReportResults results;
  results.worlds = read_worlds(json, reading);
  results.json = json.dump();
  if (!reading.error().empty()) return {std::nullopt, Problem{0, 0, reading.error()}};
  return {std::move(results), std::nullopt};
}

}  // namespace labmouse
