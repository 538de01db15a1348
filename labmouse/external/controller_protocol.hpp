// The lines between us and an external mouse that drives a mouse itself. docs/reference/protocols.md has them in words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/external/verdict.hpp"

namespace labmouse {

/// The first line of both sides: the protocol and its version.
inline constexpr std::string_view controller_greeting = "labmouse pilot 1";

/// For so many milliseconds an answer may have duties.
inline constexpr std::size_t longest_batch = 64;

/// Adds what was read at a tick, as numbers with a blank before each.
void add_sense(const Sense& sense, std::string& text);

/// What an answer has the mouse do, tick by tick, its word with the first of them; nothing where it is none.
std::optional<std::vector<ControllerTick>> read_duties(std::string_view line);

/// Nothing where its first line is the greeting.
std::optional<Verdict> judge_controller_greeting(std::string_view line);

/// What an answer says, a line without its end, unless the external mouse wrote more behind it or it is none.
struct DutiesAnswer {
  std::vector<ControllerTick> ticks;
  std::optional<Verdict> verdict;
};
DutiesAnswer judge_duties(std::string_view line, std::string_view more);

}  // namespace labmouse
