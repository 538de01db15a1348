#include "labmouse/lab/mms/mms_entry.hpp"

#include "labmouse/lab/mms/mms_world.hpp"
#include "labmouse/lab/replays/replay.hpp"

namespace labmouse {

const WorldEntry mms_entry = {.name = "mms",
                              .summary = "the simulator mms, for programs written for it",
                              .settings = settings_of<mms_rows>,
                              .make = make_by<mms_rows, mms_world>,
                              .records = &mms_records};

}  // namespace labmouse
