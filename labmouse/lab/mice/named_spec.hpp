// NAME=SPEC: a SPEC with the name that its user gave the mouse.
#pragma once

#include <string_view>

namespace labmouse {

struct NamedSpec {
  std::string_view name;  ///< empty if the user gave none
  std::string_view spec;
};

/// Splits NAME=SPEC. The `=` after a name comes before any other sign of a SPEC: the colon of a parameter or an
/// external mouse, the comma before another mouse, and slashes and blanks of a command.
constexpr NamedSpec named_spec(std::string_view text) {
  const auto end = text.find_first_of("=:,/ ");
  if (end == std::string_view::npos || end == 0 || text[end] != '=') return {{}, text};
  return {text.substr(0, end), text.substr(end + 1)};
}

/// Whether a SPEC is that of a mice file, `mice-file:FILE` or `mice-file:FILE:NAME`. It reaches to the end of the text.
constexpr bool is_mice_file_spec(std::string_view spec) {
  return spec.starts_with("mice-file:") || spec.starts_with("lineup:");
}

}  // namespace labmouse
