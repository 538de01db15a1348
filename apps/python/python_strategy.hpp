// A strategy that is an object of Python.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <memory>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/driving_strategy.hpp"

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

/// The strategy of one contest. It holds the interpreter's lock from its making to its end, which are to be in the same
/// thread. Once `stop`, which may be null, is true, it decides no more: its forfeit is an interruption.
std::unique_ptr<DrivingStrategy> make_python_strategy(const std::shared_ptr<const MouseMaker>& maker,
                                                      const Briefing& briefing, const std::atomic<bool>* stop);

}  // namespace labmouse::python
