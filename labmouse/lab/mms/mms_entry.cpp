#include "labmouse/lab/mms/mms_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/lab/mms/mms_world.hpp"
#include "labmouse/lab/records/record_file.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

constexpr std::array settings = {
    WorldSetting{"strict", "", "In mms: end a run at the first line that mms would not answer",
                 WorldSetting::Kind::flag, "false"},
    WorldSetting{"presses", "N", "In mms: press Reset N times when a mouse waits for it", WorldSetting::Kind::whole,
                 "0", 0, 1'000'000},
    WorldSetting{"simulated-limit", "SECONDS", "In mms: end a run after this simulated time; its best run counts",
                 WorldSetting::Kind::whole, "3600", 1, 1'000'000},
    WorldSetting{"line-limit", "N", "In mms: end a run after N lines; its best run counts", WorldSetting::Kind::whole,
                 "10000000", 1, 2'000'000'000}};

WorldResult make(const WorldSettings& chosen) {
  MmsOptions options;
  options.strict = value_of(mms_entry, chosen, "strict") == "true";
  options.presses = whole_of(mms_entry, chosen, "presses");
  options.most_seconds = whole_of(mms_entry, chosen, "simulated-limit");
  options.most_lines = whole_of(mms_entry, chosen, "line-limit");
  return {mms_world(options), ""};
}

PackedFile failed(Problem problem) { return {"", std::nullopt, std::move(problem)}; }

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// The first line of the text that is not JSON; 0 where all are.
int first_bad_line(std::string_view text) {
  for (int line = 1; !text.empty(); ++line) {
    const auto length = std::min(text.find('\n'), text.size());
    if (read_json(text.substr(0, length)).is_discarded()) return line;
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return 0;
}

/// A record of mms goes in as it is.
PackedFile pack(std::string_view text, const RecordOwner& owner) {
  if (const int line = first_bad_line(text); line > 0) return failed({line, 1, "the line is not JSON"});
  Json header = read_ordered_json(text.substr(0, text.find('\n')));
  if (!header.is_object() || header.value("labmouse", Json()) != "mms record")
    return failed({1, 1, "is not the header of an mms record"});
  // But for that word its header is that of a record, so that one reader serves both.
  header["labmouse"] = "record";
  ReadRecordResult read = read_record(text_of(header));
  if (!read.file) return failed(read.problems.front());
  if (read.file->mouse != owner.mouse || read.file->maze_name != owner.maze)
    return failed(
        {0, 0, fmt::format("does not belong to this race: it is of {} in {}", read.file->mouse, read.file->maze_name)});
  return {text_of({{"mouse", read.file->mouse}, {"maze", read.file->maze_name}, {"mms", text}}), read.file->maze,
          std::nullopt, false};
}

}  // namespace

const WorldEntry mms_entry = {"mms", "the simulator mms, for programs written for it", settings, make, pack};

}  // namespace labmouse
