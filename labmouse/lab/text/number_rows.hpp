// Compresses rows of whole numbers, each similar to the one before, to a short text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace labmouse {

/// Writes each number as its difference from the one above (0 above the first row), in base64 VLQ as in source maps:
/// five bits a digit, the lowest first, plus 32 where more digits follow; the lowest bit of all is the sign. `~` and a
/// number n repeat a row n more times.
std::string rows_text(std::span<const std::int32_t> numbers, std::size_t columns);

/// Reads such a text and appends its numbers. Returns false for an invalid text, or where there would be more than
/// `most`.
bool read_rows(std::string_view text, std::size_t columns, std::size_t most, std::vector<std::int32_t>& numbers);

}  // namespace labmouse
