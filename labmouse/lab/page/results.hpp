// Validates results of races for the page: type `RaceResults` in apps/web/page/src/core/types.ts.
#pragma once

#include <string>

#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// Reads untrusted output of `labmouse race --format json`. The result has all fields of the page's type, with values
/// of the right types, and refers only to its own mazes. Further fields are kept only if they are plain values, lists
/// of texts, or objects of plain values. Fields that may be null may be missing. Returns the error, or an empty text.
std::string read_results(const ReadJson& json, Json& results);

}  // namespace labmouse
