// The list of built-in mice as JSON.
#pragma once

#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// An array of objects with `name`, `summary`, `is_stochastic`, `walks`, `drives`, `parameters`, `method` and `source`,
/// the simplest mouse first. A parameter has `name`, `type`, `default`, `meaning`, either `low` and `high` or
/// `choices`, and `counts_in` if it has an effect only in some worlds.
Json mice_json();

}  // namespace labmouse
