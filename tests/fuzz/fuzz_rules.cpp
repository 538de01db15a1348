// Any bytes as rules in seconds: there are rules within their ranges, or there are problems.
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(rules) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const DriveRulesResult read = read_drive_rules(text, "fuzz");
  require(read.rules.has_value() == read.problems.empty());
  require(read.problems.size() <= most_problems);
  if (!read.rules) return 0;
  const DriveRules& rules = *read.rules;
  require(rules.time_limit >= 1'000'000 && rules.time_limit <= 7'200'000'000);
  require(rules.most_runs >= 1 && rules.most_runs <= 100);
  require(rules.maze_time_divisor >= 0 && rules.touch_penalty >= 0 && rules.untouched_bonus >= 0);
  return 0;
}

}  // namespace labmouse::fuzz
