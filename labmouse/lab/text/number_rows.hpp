// Rows of whole numbers, each much like the one before, as a short text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace labmouse {

/// Each number as its difference from the one above it (the first row from zeros), in base64 VLQ as in source maps:
/// five bits a digit, the lowest first, 32 added where more follow, and the sign as the lowest bit of all. `~` and a
/// number of the same kind repeat a row so many times.
std::string rows_text(std::span<const std::int32_t> numbers, std::size_t columns);

/// Reads such a text to the end of the numbers; false where it is none, or they would become more than `most`.
bool read_rows(std::string_view text, std::size_t columns, std::size_t most, std::vector<std::int32_t>& numbers);

}  // namespace labmouse
