// The one list of all worlds. A new one stands here, and nowhere else outside of its own folder.
#include <array>

#include "labmouse/lab/drive/drive_entries.hpp"
#include "labmouse/lab/mms/mms_entry.hpp"
#include "labmouse/lab/steps/steps_entry.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {

std::span<const WorldEntry* const> all_worlds() {
  // A mouse races in the first one that takes it, unless told otherwise: a program for mms in that of mms.
  static constexpr std::array<const WorldEntry*, 5> worlds = {&steps_entry, &mms_entry, &seconds_entry, &physical_entry,
                                                              &failures_entry};
  return worlds;
}

}  // namespace labmouse
