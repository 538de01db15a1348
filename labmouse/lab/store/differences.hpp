// Names the differences between the conditions of races in one world, in a few words.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace labmouse {

/// For each of several conditions (JSON objects), its values where they differ: "budget 500", "robot kerise" where the
/// names differ, or "robot straight.speed 1500" for robots of one name. All empty where they are equal or one is no
/// object.
std::vector<std::string> differences_of(std::span<const std::string> conditions);

}  // namespace labmouse
