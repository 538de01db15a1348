// Line protocol between labmouse and an external controller. docs/reference/protocols.md explains it.
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

/// Largest number of milliseconds for which an answer may have duties.
inline constexpr std::size_t longest_batch = 64;

/// Appends the readings of a tick to a text, as numbers with a blank before each.
void add_sense(const Sense& sense, std::string& text);

/// Parses an answer into duties tick by tick; the first tick has the answer's word. nullopt if it is invalid.
std::optional<std::vector<ControllerTick>> read_duties(std::string_view line);

/// Checks the first line; nullopt if it is the greeting.
std::optional<Verdict> judge_controller_greeting(std::string_view line);

/// A parsed answer: its ticks, or a verdict if it is invalid.
struct DutiesAnswer {
  std::vector<ControllerTick> ticks;
  std::optional<Verdict> verdict;
};
DutiesAnswer judge_duties(std::string_view line, std::string_view more);

}  // namespace labmouse
