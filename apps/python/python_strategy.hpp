// A strategy that is an object of Python.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <memory>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/driving_strategy.hpp"

namespace labmouse::python {

/// Owns the callables that make one mouse: `maker` takes the briefing of a contest and returns an object that decides;
/// `elsewhere` is as in OwnMouse. Threads without the GIL may own and destroy it.
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

  /// Call with the GIL.
  const nanobind::object& maker() const { return maker_; }
  const nanobind::object& elsewhere() const { return elsewhere_; }

 private:
  nanobind::object maker_, elsewhere_;
};

/// Makes the strategy of one contest. It holds the GIL from construction to destruction, which must happen in the same
/// thread; the caller may release the GIL between calls. Once `stop` (may be null) is true, it forfeits with the reason
/// `interrupted`.
std::unique_ptr<DrivingStrategy> make_python_strategy(const std::shared_ptr<const MouseMaker>& maker,
                                                      const Briefing& briefing, const std::atomic<bool>* stop);

}  // namespace labmouse::python
