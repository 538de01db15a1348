// Parts of our controller that are somebody else's, in C and linked in, by their table of functions.
#pragma once

#include <memory>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/controller/parts.hpp"
#include "labmouse/hardware/labmouse_controller.h"

namespace labmouse {

/// Such parts for one contest.
class PartsInC {
 public:
  virtual ~PartsInC() = default;
  /// For drive_physically(); they live as long as this.
  virtual ControllerParts parts() = 0;
};

/// The table must outlive it; its functions may be called from several threads at once, each for contests of its own.
std::unique_ptr<PartsInC> parts_in_c(const struct labmouse_parts& table, const ControllerBriefing& briefing);

}  // namespace labmouse
