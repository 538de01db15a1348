// A mouse that a user of Python wrote, as one that takes part in races.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <string>

#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse::python {

/// A mouse in Python: its name, what makes it once a contest, and whether it is stochastic. `elsewhere` is None where
/// the mouse is to decide in this process. Else it is called with each contest in steps, as play() behind the maker,
/// and gives what play() gave in another process; and its `begin` takes a briefing and gives what decides there:
/// live_strategy.
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
