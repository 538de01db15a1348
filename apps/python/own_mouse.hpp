// Makes a contestant of a mouse that a user wrote in Python.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <string>

#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse::python {

/// A mouse in Python: its name, the callable that makes it for each contest, and whether it is stochastic. `elsewhere`
/// is None if the mouse decides in this process. Otherwise it is called with the briefing of each contest and returns
/// a Contest (labmouse/_workers.py), which decides in another process.
struct OwnMouse {
  std::string name;
  nanobind::object maker;
  bool uses_chance = false;
  nanobind::object elsewhere;
  std::string identity;  ///< see Contestant::identity; empty if unknown
};

/// The contestant of such a mouse, for all worlds that ask a mouse for decisions. Once `stop` (may be null) is true, it
/// forfeits.
Contestant python_contestant(OwnMouse mouse, const std::atomic<bool>* stop);

}  // namespace labmouse::python
