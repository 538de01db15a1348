// A mouse that a user of Python wrote, as one that takes part in races.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <string>

#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/lab/races/world_entry.hpp"

namespace labmouse::python {

/// A mouse in Python: its name, what makes it once a contest, and whether it throws dice. `elsewhere` may be None, or
/// is called before each contest with what play() takes behind the maker: it gives what play() gave in another process,
/// or None where the contest is to be held here.
struct OwnMouse {
  std::string name;
  nanobind::object maker;
  bool uses_chance = false;
  nanobind::object elsewhere;
  std::string identity;  ///< as of Contestant; empty where nothing is known of it
};

/// Such a mouse as a contestant, in steps and in seconds. Other processes need the settings of its world. Once `stop`,
/// which may be null, is true, it decides no more.
Contestant python_contestant(OwnMouse mouse, const WorldSettings& settings, const std::atomic<bool>* stop);

}  // namespace labmouse::python
