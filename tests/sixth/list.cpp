// All worlds with one more: this file takes the place of labmouse/lab/worlds/list.cpp.
#include <array>

#include "labmouse/lab/drive/drive_entries.hpp"
#include "labmouse/lab/mms/mms_entry.hpp"
#include "labmouse/lab/steps/steps_entry.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/sixth/battery_entry.hpp"

namespace labmouse {

std::span<const WorldEntry* const> all_worlds() {
  static constexpr std::array<const WorldEntry*, 6> worlds = {&steps_entry,    &seconds_entry, &physical_entry,
                                                              &failures_entry, &mms_entry,     &battery_entry};
  return worlds;
}

}  // namespace labmouse
