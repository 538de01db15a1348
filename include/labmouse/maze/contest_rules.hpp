// The official rules for the maze of a classic (16×16) or half-size (32×32) micromouse contest.
//
// Source: the maze rules of the All Japan Micromouse Contest (New Technology Foundation) and of the IEEE Region
// contests, and two customs of maze designers: a wall follower must fail, and there is a choice of routes. Lengths,
// colours and materials are not checked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The result of checking one rule.
struct RuleFinding {
  /// A short name: "size", "start", "posts" and so on.
  std::string_view name;
  bool passed = false;
  /// What is wrong and where (the first few places); empty when the rule is kept.
  std::string reason;
};

/// Checks all rules.
/// @param maze of any size.
/// @return one finding a rule, always in this order: size, border, start, goal room, entrance, posts, goal reachable,
///   left wall follower, right wall follower, routes.
std::vector<RuleFinding> check_contest_rules(const Maze& maze);

/// Whether the maze keeps all rules.
/// @param maze of any size.
bool keeps_contest_rules(const Maze& maze);

}  // namespace labmouse
