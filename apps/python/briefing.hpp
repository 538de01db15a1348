// The class behind labmouse.Briefing.
#pragma once

#include "labmouse/mouse/briefing.hpp"

namespace labmouse::python {

/// labmouse.Briefing: what a mouse in Python is given before its contest.
struct PythonBriefing {
  Briefing briefing;
};

}  // namespace labmouse::python
