// The list of built-in mice as JSON: what each mouse does, and its parameters with defaults and ranges.
#pragma once

#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// A list of `name`, `summary`, `is_stochastic` and `parameters`, the simplest mouse first. A parameter has `name`,
/// `type`, `default`, `meaning`, and `low` and `high`, or `choices`.
Json mice_json();

}  // namespace labmouse
