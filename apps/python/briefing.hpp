// What a mouse in Python knows before its contest.
#pragma once

#include "labmouse/mouse/briefing.hpp"

namespace labmouse::python {

/// labmouse.Briefing.
struct PythonBriefing {
  Briefing briefing;
};

}  // namespace labmouse::python
