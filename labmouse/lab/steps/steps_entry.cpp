#include "labmouse/lab/steps/steps_entry.hpp"

#include "labmouse/lab/replays/replay.hpp"
#include "labmouse/lab/steps/steps_world.hpp"

namespace labmouse {

const WorldEntry steps_entry = {
    .name = "steps",
    .former_name = "strides",
    .summary = "the rules of the capstone project: a step turns, then moves up to three cells",
    .settings = settings_of<steps_rows>,
    .make = make_by<steps_rows, steps_world>,
    .records = &steps_records};

}  // namespace labmouse
