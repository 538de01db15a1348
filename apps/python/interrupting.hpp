// How a mouse in Python is stopped in the middle of its contest.
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>

namespace labmouse::python {

/// How often a wait for a mouse looks whether it shall stop.
inline constexpr std::chrono::milliseconds glance{10};
/// How often a mouse is interrupted before it is left behind in its thread: one that catches the exception once or
/// twice comes to its end.
inline constexpr int times_told = 3;

/// Makes a thread of Python raise what Ctrl-C raises. Not with the interpreter's lock.
inline void interrupt(unsigned long thread) {
  const nanobind::gil_scoped_acquire lock;
  PyThreadState_SetAsyncExc(thread, PyExc_KeyboardInterrupt);
}

}  // namespace labmouse::python
