// A mouse that a user of Python wrote, as one that takes part in races.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <string>

#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse::python {

/// A mouse in Python: its name, what makes it once a contest, and whether it is stochastic. `elsewhere` is None where
/// the mouse decides in this process. Else it is called with the briefing of each contest and returns what decides in
/// another process: Contest of labmouse/_workers.py.
struct OwnMouse {
  std::string name;
  nanobind::object maker;
  bool uses_chance = false;
  nanobind::object elsewhere;
  std::string identity;  ///< as of Contestant; empty where nothing is known of it
};

/// Such a mouse as a contestant, in all worlds whose mice decide. Once `stop`, which may be null, is true, it decides
/// no more.
Contestant python_contestant(OwnMouse mouse, const std::atomic<bool>* stop);

}  // namespace labmouse::python
