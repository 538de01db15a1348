// Results of races as the page takes them: `RaceResults` in apps/web/page/src/core/types.ts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace labmouse {

/// Results, or what is wrong with them: exactly one of the two is there.
struct ReadResultsResult {
  nlohmann::ordered_json results;
  std::string error;
};

/// Reads what `labmouse race --format json` wrote, and trusts none of it: what comes out has all fields of the page's type
/// with values of their types, no others, and names no maze that it does not have. What is null in results may be missing.
ReadResultsResult read_results(const nlohmann::json& json);

}  // namespace labmouse
