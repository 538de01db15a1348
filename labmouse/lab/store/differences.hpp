// What tells the conditions of two races in one world apart, in a few words.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace labmouse {

/// Of each of several conditions, objects of JSON, what it has where they differ: "budget 500", "robot kerise" where
/// the names differ, or "robot straight.speed 1500" of robots of one name. Empty of all where they are equal or one is
/// no object.
std::vector<std::string> differences_of(std::span<const std::string> conditions);

}  // namespace labmouse
