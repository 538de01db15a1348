// The lab's figures as Python has them.
#pragma once

#include <nanobind/nanobind.h>

#include "labmouse/lab/races/value.hpp"

namespace labmouse::python {

/// None, a truth, a number, a text; of lists and objects what they hold.
nanobind::object object_of(const Value& value);

/// What a text of JSON says, as lists and dictionaries.
nanobind::object read_json(const std::string& text);

}  // namespace labmouse::python
