// The roster as JSON: what each mouse does, and its parameters with defaults and ranges.
#pragma once

#include <nlohmann/json.hpp>

namespace labmouse {

/// A list of `name`, `summary`, `throws_dice` and `parameters`, the simplest mouse first. A parameter has `name`,
/// `type`, `default`, `meaning`, and `low` and `high`, or `choices`.
nlohmann::ordered_json mice_json();

}  // namespace labmouse
