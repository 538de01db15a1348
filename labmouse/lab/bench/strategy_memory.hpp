// How much memory strategies take in the world of seconds: what a real mouse would have to have.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "labmouse/mouse/drive/memory_part.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

struct StrategyMemory {
  Size size;
  std::size_t fields = 0;                  ///< in bytes, exactly: DriveFields
  MemoryLayout layout;                     ///< what the fields are spent on
  std::size_t tables = 0;                  ///< that all strategies of the robot share, and that are constant
  std::map<std::string, std::size_t> own;  ///< by mouse: what it takes besides, in bytes of the heap, measured
};

/// Of all mice that drive, with their defaults, in mazes of a size up to 32×32.
StrategyMemory strategy_memory(Size size, const DriveModel& model);

}  // namespace labmouse
