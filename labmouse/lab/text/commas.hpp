// Lists in one word of a command line: "classic,half".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace labmouse {

/// The parts of a text between its commas, at least one; parts may be empty.
inline std::vector<std::string> between_commas(std::string_view text) {
  std::vector<std::string> parts;
  for (;;) {
    const auto comma = text.find(',');
    parts.emplace_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace labmouse
