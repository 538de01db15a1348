// Wall readings as objects of Python.
#pragma once

#include <nanobind/nanobind.h>

#include "labmouse/mouse/sighting.hpp"

namespace labmouse::python {

/// The labmouse.Sighting of a reading, a borrowed reference. Each distinct reading is made once and kept for ever:
/// sightings are immutable, and making one takes longer than all other work of a decision.
nanobind::handle sighting_of(const Sighting& seen);

}  // namespace labmouse::python
