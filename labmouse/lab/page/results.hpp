// Results of races as the page takes them: `RaceResults` in apps/web/page/src/core/types.ts.
#pragma once

#include <string>

#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// Reads what `labmouse race --format json` wrote, and trusts none of it: what comes out has all fields of the page's
/// type with values of their types, no others, and names no maze that it does not have. What is null in results may be
/// missing. Returns what is wrong, or nothing.
std::string read_results(const ReadJson& json, Json& results);

}  // namespace labmouse
