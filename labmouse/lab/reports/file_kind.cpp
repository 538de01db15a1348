#include "labmouse/lab/reports/file_kind.hpp"

#include <algorithm>
#include <array>

#include "labmouse/functions/byte_order_mark.hpp"
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

bool is_page(std::string_view text) {
  constexpr std::size_t longest_head = 4096;
  if (!text.starts_with("<!doctype html>")) return false;
  if (text.substr(0, longest_head).find("<title>labmouse") != text.npos) return true;
  return text.find("labmouse:report") != text.npos || text.find("labmouse-report") != text.npos;
}

struct Beginning {
  FileKind kind;
  std::string_view begin;
};

/// Also those of earlier versions.
constexpr auto beginnings = std::to_array<Beginning>({
    {FileKind::csv, "mouse,maze,"},
    {FileKind::picture, "<svg"},
    {FileKind::log, "time,left,right,left_count,right_count,"},
    {FileKind::prior, "// labmouse prior "},
    {FileKind::failure_rates, "{\"labmouse_failure_rates\""},
    {FileKind::failure_rates, "{\"labmouse_hazards\""},
    {FileKind::junit, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"labmouse\""},
    {FileKind::gradescope, "{\n \"extra_data\": {\n  \"labmouse\""},
    {FileKind::study, "maze,fold,bound"},
    {FileKind::sweep, "value,mean,low,high,"},
    {FileKind::tune, "evaluation,generation,step,"},
});

}  // namespace

FileKind kind_of_file(std::string_view text) {
  text = without_mark(text);
  if (is_record(text)) return FileKind::record;
  for (const Beginning& each : beginnings)
    if (text.starts_with(each.begin)) return each.kind;
  if (is_page(text)) return FileKind::page;
  if (is_results(text)) return FileKind::results;
  const ReadResult read = read_maze(text);
  // A program that has a maze in it is more than a maze.
  const bool is_more = read.maze && recognised_format(text) == &c_format && c_format.write(*read.maze).content != text;
  return (read.maze || read.partial) && !is_more ? FileKind::maze : FileKind::unknown;
}

}  // namespace labmouse
