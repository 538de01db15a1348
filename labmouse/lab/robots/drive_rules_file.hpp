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

/// Reads rules from a text of at most 64 KiB and gives them the name `name`.
DriveRulesResult read_drive_rules(std::string_view text, std::string_view name);

/// Rules, or why there are none: a line for each problem, as `describe` formats it.
struct FoundRules {
  DriveRules rules;
  std::vector<std::string> errors;
};

/// Finds rules by the name of built-in ones, or by the path of a file (a name with a slash or the ending `.toml`). They
/// get the name given here.
FoundRules find_rules(const std::string& name);

}  // namespace labmouse
