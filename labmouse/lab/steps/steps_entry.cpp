#include "labmouse/lab/steps/steps_entry.hpp"

#include <array>

#include "labmouse/lab/replays/replay.hpp"
#include "labmouse/lab/steps/steps_world.hpp"

namespace labmouse {
namespace {

constexpr std::array settings = {WorldSetting{"budget", "N", "Step limit of a contest, for both runs together",
                                              WorldSetting::Kind::whole, "1000", 1, 1'000'000}};

WorldResult make(const WorldSettings& chosen) {
  Rules rules;
  rules.budget = whole_of(steps_entry, chosen, "budget");
  return {steps_world(rules), ""};
}

}  // namespace

const WorldEntry steps_entry = {
    .name = "steps",
    .former_name = "strides",
    .summary = "the rules of the capstone project: a step turns, then moves up to three cells",
    .settings = settings,
    .make = make,
    .records = &steps_records};

}  // namespace labmouse
