// SPECs of built-in mice with parts of the controller in a program: `name[:key=value]...:parts=COMMAND`. Everything
// after the equals sign, including colons and commas, belongs to the command.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace labmouse {

inline constexpr std::string_view parts_key = ":parts=";

/// Where `:parts=` stands in the first SPEC of a text; npos if it has no such parts. SPECs of other programs and of
/// mice files, today's and former ones, take everything after their colon.
constexpr std::size_t parts_place(std::string_view text) {
  constexpr std::array<std::string_view, 9> others = {
      "capstone:", "program:", "guest:", "mms:", "controller:", "firmware:", "pilot:", "mice-file:", "lineup:"};
  const bool is_other =
      std::any_of(others.begin(), others.end(), [&](std::string_view other) { return text.starts_with(other); });
  return is_other ? std::string_view::npos : text.substr(0, text.find(',')).find(parts_key);
}

}  // namespace labmouse
