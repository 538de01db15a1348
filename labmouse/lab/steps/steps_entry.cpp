#include "labmouse/lab/steps/steps_entry.hpp"

#include <fmt/format.h>

#include <array>

#include "labmouse/lab/records/packed_record.hpp"
#include "labmouse/lab/steps/steps_world.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

constexpr std::array settings = {WorldSetting{"budget", "INT", "Step limit of a contest, for both runs together",
                                              WorldSetting::Kind::whole, "1000", 1, 1'000'000}};

WorldResult make(const WorldSettings& chosen) {
  Rules rules;
  rules.budget = whole_of(steps_entry, chosen, "budget");
  return {steps_world(rules), ""};
}

PackedFile failed(Problem problem) { return {"", std::nullopt, std::move(problem)}; }

PackedFile pack(std::string_view text, const RecordOwner& owner) {
  ReadRecordResult read = read_record(text);
  if (!read.file) return failed(read.problems.front());
  RecordFile& file = *read.file;
  if (!file.maze) return failed({0, 0, "the record does not contain its maze"});
  if (file.mouse != owner.mouse || file.maze_name != owner.maze || !owner.seeds.contains(file.seed))
    return failed({0, 0,
                   fmt::format("does not belong to this race: it is of {} in {} with seed {}", file.mouse,
                               file.maze_name, file.seed)});
  const ReplayResult played = replay(file, *file.maze);
  if (!played.disagreement.empty()) return failed({0, 0, "the record does not match its maze: " + played.disagreement});
  return {pack_record(file).dump(-1, ' ', false, Json::error_handler_t::replace), file.maze, std::nullopt};
}

}  // namespace

const WorldEntry steps_entry = {
    "strides", "the rules of the capstone project: a step turns, then moves up to three cells",
    settings,  make,
    pack,      true,
    nullptr,   "run"};

}  // namespace labmouse
