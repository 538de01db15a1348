// Memory of strategies in the world of seconds, as a microcontroller would need it.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "labmouse/mouse/drive/memory_part.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

struct StrategyMemory {
  Size size;
  std::size_t fields = 0;                  ///< of DriveFields, in bytes
  MemoryLayout layout;                     ///< how the fields are divided
  std::size_t tables = 0;                  ///< constant tables that all strategies of the robot share, in bytes
  std::map<std::string, std::size_t> own;  ///< by mouse: further heap, in bytes, measured
};

/// Measures all mice that drive, with their defaults, in a maze of at most 32×32 cells.
StrategyMemory strategy_memory(Size size, const DriveModel& model);

}  // namespace labmouse
