// A mouse that is an object of Python, in this process or in another.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <memory>
#include <string>

#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/lab/races/world_entry.hpp"
#include "work.hpp"

namespace labmouse::python {

/// What makes the mice of one name: called with a briefing once a contest, it gives an object that decides. Held by
/// threads that do not hold the interpreter's lock.
class MouseMaker {
 public:
  MouseMaker(nanobind::object maker, nanobind::object elsewhere)
      : maker_(std::move(maker)), elsewhere_(std::move(elsewhere)) {}
  MouseMaker(const MouseMaker&) = delete;
  MouseMaker& operator=(const MouseMaker&) = delete;
  ~MouseMaker() {
    const nanobind::gil_scoped_acquire lock;
    maker_.reset();
    elsewhere_.reset();
  }

  /// Only with the interpreter's lock.
  const nanobind::object& maker() const { return maker_; }
  const nanobind::object& elsewhere() const { return elsewhere_; }

 private:
  nanobind::object maker_, elsewhere_;
};

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

/// Stops work, and what its mice in this process decide just now: they hear of it as Python's code hears of Ctrl-C.
/// Only with the interpreter's lock; to be repeated where a mouse takes no notice.
void stop(Work& work);

}  // namespace labmouse::python
