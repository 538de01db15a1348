#include "labmouse/lab/reports/file_kind.hpp"

#include <algorithm>

#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {
namespace {

constexpr std::size_t longest_header = std::size_t{1} << 20U;  // bytes of the first line of a record

bool is_record(std::string_view text) {
  const std::string_view line = text.substr(0, std::min(text.find('\n'), longest_header));
  const ReadJson header = read_json(line);
  return header.is_object() && header.contains("labmouse") && header["labmouse"] == kind_of_record(line).header;
}

bool is_results(std::string_view text) {
  if (text.find("\"labmouse\"") == std::string_view::npos) return false;
  const ReadJson json = read_json(text);
  return json.is_object() && json.contains("labmouse") && (json.contains("groups") || json.contains("mice"));
}

}  // namespace

FileKind kind_of_file(std::string_view text) {
  if (is_record(text)) return FileKind::record;
  if (text.starts_with("mouse,maze,")) return FileKind::csv;
  if (text.starts_with("<!doctype html")) return FileKind::page;
  if (is_results(text)) return FileKind::results;
  return read_maze(text).maze ? FileKind::maze : FileKind::unknown;
}

}  // namespace labmouse
