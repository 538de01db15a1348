// labmouse._native: the library for Python. What it computes comes from the library; what a user sees first is in
// apps/python/labmouse.
#include <nanobind/stl/string.h>

#include <string>

#include "bindings.hpp"
#include "labmouse/lab/system/version.hpp"

NB_MODULE(_native, module) {
  module.doc() = "The part of labmouse that is compiled.";
  module.attr("__version__") = std::string(labmouse::version());
  labmouse::python::bind_errors(module);
  labmouse::python::bind_mazes(module);
  labmouse::python::bind_sightings(module);
  labmouse::python::bind_briefings(module);
}
