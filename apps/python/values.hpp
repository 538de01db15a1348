// Converts figures and JSON to objects of Python.
#pragma once

#include <nanobind/nanobind.h>

#include "labmouse/lab/races/value.hpp"

namespace labmouse::python {

/// The value as None, bool, int, float or str; JSON as lists and dictionaries.
nanobind::object object_of(const Value& value);

/// Parses JSON with Python's json.loads. Call with the GIL.
nanobind::object read_json(const std::string& text);

}  // namespace labmouse::python
