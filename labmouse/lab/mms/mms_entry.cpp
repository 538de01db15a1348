#include "labmouse/lab/mms/mms_entry.hpp"

#include <array>

#include "labmouse/lab/mms/mms_world.hpp"
#include "labmouse/lab/replays/replay.hpp"

namespace labmouse {
namespace {

constexpr std::array settings = {
    WorldSetting{"strict", "", "End a run at the first line that mms would not answer", WorldSetting::Kind::flag,
                 "false"},
    WorldSetting{"presses", "N", "Press Reset N times when a mouse waits for it", WorldSetting::Kind::whole, "0", 0,
                 1'000'000},
    WorldSetting{"simulated-limit", "SECONDS", "End a run after this simulated time; its best run counts",
                 WorldSetting::Kind::whole, "3600", 1, 1'000'000},
    WorldSetting{"line-limit", "N", "End a run after N lines; its best run counts", WorldSetting::Kind::whole,
                 "10000000", 1, 2'000'000'000}};

WorldResult make(const WorldSettings& chosen) {
  MmsOptions options;
  options.strict = value_of(mms_entry, chosen, "strict") == "true";
  options.presses = whole_of(mms_entry, chosen, "presses");
  options.most_seconds = whole_of(mms_entry, chosen, "simulated-limit");
  options.most_lines = whole_of(mms_entry, chosen, "line-limit");
  return {mms_world(options), ""};
}

}  // namespace

const WorldEntry mms_entry = {.name = "mms",
                              .summary = "the simulator mms, for programs written for it",
                              .settings = settings,
                              .make = make,
                              .records = &mms_records};

}  // namespace labmouse
