#include <limits>

#include "labmouse/lab/records/mms_record_file.hpp"
#include "labmouse/lab/records/record_maze.hpp"
#include "labmouse/lab/text/json_fields.hpp"
#include "labmouse/lab/text/json_lines.hpp"

namespace labmouse {
namespace {

constexpr int largest = std::numeric_limits<int>::max();
constexpr std::size_t most_events = 1'000'000;

std::string read_maze_field(const ReadJson& json, MmsRecordFile& file) {
  JsonFields fields(json, "maze");
  file.maze_name = fields.text("name");
  file.maze = read_record_maze(fields);
  return fields.error();
}

std::string read_mouse_field(const ReadJson& json, MmsRecordFile& file) {
  JsonFields fields(json, "mouse");
  file.mouse = fields.text("name");
  return fields.error();
}

std::string read_header(const ReadJson& json, MmsRecordFile& file) {
  JsonFields fields(json, "");
  if (fields.text("labmouse") != "mms record") fields.fail("is not the header of an mms record");
  if (fields.whole("format", 0, largest) != 1) fields.fail("has a format other than 1, which this version cannot read");
  file.version = fields.text("version");
  for (const char* key : {"maze", "mouse"})
    if (!fields.has(key)) fields.reject(fmt::format("'{}' is missing", key));
  if (!fields.error().empty()) return fields.error();
  auto error = read_maze_field(json["maze"], file);
  return error.empty() ? read_mouse_field(json["mouse"], file) : error;
}

Compass read_compass(JsonFields& fields) {
  const std::string name = fields.text("heading");
  for (int eighths = 0; eighths < 8; ++eighths)
    if (const Compass heading = turned(Compass::north, eighths); name_of(heading) == name) return heading;
  fields.fail("has a heading that is not one of the eight");
  return Compass::north;
}

HalfPlace read_place(JsonFields& fields, Size size) {
  const ReadJson& place = fields.list("place");
  if (place.size() != 2) return fields.fail("has a place that is not [x, y]", HalfPlace());
  return {fields.whole(place[0], "place", 0, 2 * size.width), fields.whole(place[1], "place", 0, 2 * size.height)};
}

std::string read_event(const ReadJson& json, MmsRecordFile& file) {
  if (file.left_out > 0) return "the line comes after the one that counts omitted events";
  if (file.events.size() >= most_events) return fmt::format("the record has more than {} events", most_events);
  JsonFields fields(json, "");
  RecordedMmsEvent event;
  event.line = fields.text("line");
  if (fields.has("reply")) event.reply = fields.text("reply");
  event.pose.place = read_place(fields, file.maze->size());
  event.pose.heading = read_compass(fields);
  event.clock = fields.not_negative("clock");
  file.events.push_back(std::move(event));
  return fields.error();
}

MmsStatistics read_statistics(const ReadJson& json, JsonFields& outer) {
  JsonFields fields(json, "statistics");
  MmsStatistics statistics;
  constexpr double most = std::numeric_limits<float>::max();
  for (const MmsStatistic& statistic : mms_statistics)
    statistics.*statistic.value = static_cast<float>(fields.number(std::string(statistic.name).c_str(), -most, most));
  outer.reject(fields.error());
  return statistics;
}

/// A count of lines, which can be more than an int holds.
std::int64_t read_count(JsonFields& fields, const ReadJson& json, const char* key) {
  constexpr double exact = 9007199254740992.0;  // 2^53
  if (fields.has(key) && !json[key].is_number_integer()) fields.reject(fmt::format("'{}' is not a whole number", key));
  return static_cast<std::int64_t>(fields.number(key, 0, exact));
}

std::string read_end(const ReadJson& json, MmsRecordFile& file) {
  JsonFields fields(json, "");
  MmsRecordEnd end;
  end.outcome = fields.text("outcome");
  end.end = fields.text("end");
  if (!fields.has("statistics")) return "'statistics' is missing";
  end.statistics = read_statistics(json["statistics"], fields);
  end.statistics.finished = fields.flag("finished");
  end.lines = read_count(fields, json, "lines");
  end.invalid_lines = read_count(fields, json, "invalid_lines");
  for (const ReadJson& sentence : fields.list("log"))
    if (sentence.is_string())
      end.log.push_back(sentence.get<std::string>());
    else
      fields.fail("has a log entry that is not a string");
  end.errors = fields.text("errors");
  end.clock = fields.not_negative("clock");
  file.end = std::move(end);
  return fields.error();
}

/// Reads one line after the header; returns what is wrong, or nothing.
std::string read_line(const ReadJson& json, MmsRecordFile& file) {
  if (file.end) return "the line comes after the end of the record";
  const auto has = [&](const char* key) { return json.is_object() && json.contains(key); };
  if (has("outcome")) return read_end(json, file);
  if (has("labmouse")) return "the line is a second header; a file must hold only one record";
  if (!has("left_out")) return read_event(json, file);
  JsonFields fields(json, "");
  if (file.left_out > 0) fields.fail("counts the omitted events a second time");
  file.left_out = read_count(fields, json, "left_out");
  return fields.error();
}

}  // namespace

ReadMmsRecordResult read_mms_record(std::string_view text) {
  MmsRecordFile file;
  std::vector<Problem> problems =
      read_json_lines(text, {[&](const ReadJson& line) { return read_header(line, file); },
                             [&](const ReadJson& line) { return read_line(line, file); }, [&] { return !file.end; }});
  if (!problems.empty()) return {std::nullopt, std::move(problems)};
  return {std::move(file), {}};
}

}  // namespace labmouse
