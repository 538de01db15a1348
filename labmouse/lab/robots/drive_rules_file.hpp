// The rules of contests in seconds as files, described in docs/reference/worlds-and-rules.md: TOML with times in
// seconds.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// Rules, or what is wrong with their file: exactly one of the two is there.
struct DriveRulesResult {
  std::optional<DriveRules> rules;
  std::vector<Problem> problems;
};

/// Reads rules of at most 64 KiB, which will have that name.
DriveRulesResult read_drive_rules(std::string_view text, std::string_view name);

/// Rules, or why there are none: a line for each problem, as `describe` words them.
struct FoundRules {
  DriveRules rules;
  std::vector<std::string> errors;
};

/// The built-in rules of that name, or those of a file, whose name has a slash or ends in `.toml`. Rules' own name is
/// the one given here.
FoundRules find_rules(const std::string& name);

}  // namespace labmouse
