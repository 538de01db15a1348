// A mouse that is an object of Python.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <memory>
#include <string>

#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse::python {

/// What makes the mice of one name: called with a briefing once a contest, it gives an object that decides. Held by
/// threads that do not hold the interpreter's lock.
class MouseMaker {
 public:
  explicit MouseMaker(nanobind::object maker) : maker_(std::move(maker)) {}
  MouseMaker(const MouseMaker&) = delete;
  MouseMaker& operator=(const MouseMaker&) = delete;
  ~MouseMaker() {
    const nanobind::gil_scoped_acquire lock;
    maker_.reset();
  }

  /// Only with the interpreter's lock.
  const nanobind::object& maker() const { return maker_; }

 private:
  nanobind::object maker_;
};

/// Such a mouse as a contestant. Once `stop`, which may be null, is true, it decides no more.
Contestant python_contestant(const std::string& name, nanobind::object maker, bool uses_chance,
                             const std::atomic<bool>* stop);

}  // namespace labmouse::python
