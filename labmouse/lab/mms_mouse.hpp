// A program written for mms that takes part in a race.
#pragma once

#include <string>

#include "labmouse/guests/process.hpp"

namespace labmouse {

struct MmsMouse {
  /// The SPEC: "mms:COMMAND".
  std::string name;
  Launch launch;
};

}  // namespace labmouse
