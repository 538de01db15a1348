// The difference of two mice or robots in the same mazes, for tables and JSON.
#pragma once

#include <string>

#include "labmouse/lab/standings/mouse_pair.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// The headings above difference_columns().
std::string difference_heading();

/// The mean difference, its interval and the verdict in columns, with a blank before them.
std::string difference_columns(const PairedDifference& found, TestVerdict verdict);

/// The interval of the mean, multiplied by `factor`; null for fewer than two mazes.
Json interval_json(const PairedDifference& found, double factor = 1.0);

/// The fields `mazes` to `sign_test` of a comparison: docs/reference/results.md has their meaning.
Json difference_json(const PairedDifference& found, const PairVerdicts& verdicts);

}  // namespace labmouse
