// Stops a mouse in Python in the middle of a decision.
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>

namespace labmouse::python {

/// Interval at which a wait for a mouse checks whether to stop.
inline constexpr std::chrono::milliseconds glance{10};
/// Number of interrupts after which a mouse is abandoned in its thread. More than one, since a mouse may catch the
/// exception once or twice and still end.
inline constexpr int times_told = 3;

/// Raises KeyboardInterrupt in a thread of Python. Takes the GIL itself.
inline void interrupt(unsigned long thread) {
  const nanobind::gil_scoped_acquire lock;
  PyThreadState_SetAsyncExc(thread, PyExc_KeyboardInterrupt);
}

}  // namespace labmouse::python
