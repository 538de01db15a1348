// What records have in common, as lines of JSON or packed, read strictly.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

// Limits on what a hostile record can make us hold.
inline constexpr int longest_record = 1'000'000;              // steps
inline constexpr std::size_t longest_last_words = 1U << 16U;  // bytes

/// Reads the object `rules` over those that are there; returns what is wrong, or nothing.
std::string read_record_rules(const ReadJson& json, Rules& rules);

/// Reads the object `counts`, what the mouse counted; returns what is wrong, or nothing.
std::string read_record_counts(const ReadJson& json, std::vector<Count>& counts);

/// The outcome of that name.
std::optional<Outcome> outcome_of(std::string_view name);

}  // namespace labmouse
