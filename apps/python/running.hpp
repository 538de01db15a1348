// What Python sees of work that runs in a thread, whatever its result.
#pragma once

#include <nanobind/nanobind.h>

#include "work.hpp"

namespace labmouse::python {

/// Binds the members that all kinds of running work have: remarks, settings, progress, and their result.
template <class Running>
void bind_running(nanobind::class_<Running>& bound) {
  bound.def_prop_ro("remarks", &Running::remarks)
      .def_prop_ro("settings", &Running::settings,
                   "The settings of the world that were given, and the defaults that depend on the mazes.")
      .def_prop_ro("done", [](Running& running) { return running.work().done(); })
      .def_prop_ro("all", [](Running& running) { return running.work().all(); })
      .def(
          "wait", [](Running& running, double seconds) { return running.work().wait(seconds); },
          nanobind::arg("seconds"))
      .def("stop", [](Running& running) { running.work().stop(); })
      .def("missing", &Running::missing)
      .def("result", &Running::result);
}

}  // namespace labmouse::python
