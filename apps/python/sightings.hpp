// What a mouse in Python is shown.
#pragma once

#include <nanobind/nanobind.h>

#include "labmouse/mouse/sighting.hpp"

namespace labmouse::python {

/// The labmouse.Sighting of a reading. There is one object for each reading, made when it is first seen and kept: it
/// never changes, and to make it takes longer than all else that is done for a decision.
nanobind::handle sighting_of(const Sighting& seen);

}  // namespace labmouse::python
