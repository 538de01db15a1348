#include "labmouse/lab/text/encoding.hpp"

#include <algorithm>

namespace labmouse {
namespace {

bool is_plain(char letter) {
  return (letter >= ' ' && letter <= '~') || letter == '\n' || letter == '\r' || letter == '\t';
}

/// UTF-16 without a byte order mark is visible in mostly ASCII text: every other byte is 0, and the others are plain. A
/// binary maze file has no bytes of 0x20 or above.
bool alternates(std::string_view bytes, std::size_t zero) {
  constexpr std::size_t looked_at = 32;
  const std::string_view begin = bytes.substr(0, looked_at);
  if (begin.size() < 4) return false;
  for (std::size_t i = 0; i < begin.size(); ++i)
    if (i % 2 == zero ? begin[i] != '\0' : !is_plain(begin[i])) return false;
  return std::any_of(begin.begin(), begin.end(), [](char letter) { return letter >= ' '; });
}

}  // namespace

std::string_view foreign_encoding(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\x1F\x8B"sv)) return "is compressed with gzip; unpack it with `gunzip` first";
  if (bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv) || alternates(bytes, 0) ||
      alternates(bytes, 1))
    return "is encoded in UTF-16; save it as UTF-8";
  return "";
}

}  // namespace labmouse
