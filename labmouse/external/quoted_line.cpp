#include "labmouse/external/quoted_line.hpp"

#include <fmt/format.h>

#include "labmouse/functions/byte_order_mark.hpp"

namespace labmouse {
namespace {

/// How much of a line is quoted, in bytes.
constexpr std::size_t most_quoted = 60;

std::string letter_shown(char letter) {
  switch (letter) {
    case '\0':
      return "\\0";
    case '\t':
      return "\\t";
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\\':
      return "\\\\";
    default:
      if (letter >= ' ' && letter <= '~') return {letter};
      return fmt::format("\\x{:02x}", static_cast<unsigned char>(letter));
  }
}

}  // namespace

std::string quoted_line(std::string_view line) {
  const bool marked = line.starts_with(byte_order_mark), returns = line.ends_with('\r');
  std::string text = marked ? "'\\ufeff" : "'";
  for (const char letter : without_mark(line.substr(0, most_quoted))) text += letter_shown(letter);
  text += line.size() > most_quoted ? "...'" : "'";
  if (marked) text += " (it begins with a byte-order mark)";
  if (returns) text += " (it ends with a carriage return)";
  return text;
}

}  // namespace labmouse
