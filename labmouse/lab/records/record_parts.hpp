// Strict readers of the parts that records share, as JSON Lines or packed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

// Limits against hostile records that would take too much memory.
inline constexpr int longest_record = 1'000'000;              // steps
inline constexpr std::size_t longest_last_words = 1U << 16U;  // bytes

/// Reads the object `rules`; keys that are missing keep their value in `rules`. Returns what is wrong, or nothing.
std::string read_record_rules(const ReadJson& json, Rules& rules);

/// Reads the object `counts`, the mouse's own counters; returns what is wrong, or nothing.
std::string read_record_counts(const ReadJson& json, std::vector<Count>& counts);

/// The outcome with that name, of today or of earlier versions.
std::optional<Outcome> outcome_of(std::string_view name);

/// The reason of a forfeit with that name, of today or of earlier versions.
std::optional<ForfeitReason> forfeit_reason_of(std::string_view name);

}  // namespace labmouse
