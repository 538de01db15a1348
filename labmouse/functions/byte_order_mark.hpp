// The byte order mark that some editors write at the beginning of a UTF-8 file.
#pragma once

#include <string_view>

namespace labmouse {

inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The text without its byte order mark, if it begins with one.
constexpr std::string_view without_mark(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

}  // namespace labmouse
