#include "labmouse/lab/text/markup.hpp"

#include <algorithm>
#include <array>

#include "labmouse/functions/byte_order_mark.hpp"

namespace labmouse {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// The text without blanks, comments and the XML declaration at its beginning.
std::string_view from_first_tag(std::string_view text) {
  text = without_mark(text);
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view end = text.starts_with("<?") ? "?>" : text.starts_with("<!--") ? "-->" : "";
    if (end.empty()) return text;
    text.remove_prefix(std::min(text.find(end), text.size() - end.size()) + end.size());
  }
}

}  // namespace

std::string first_tag(std::string_view text) {
  constexpr std::size_t most = 40;
  text = from_first_tag(text);
  std::string tag;
  if (!text.starts_with('<')) return tag;
  for (const char letter : text) {
    const bool is_blank = blanks.find(letter) != std::string_view::npos;
    if (is_blank && tag.ends_with(' ')) continue;
    if (tag.size() == most) break;
    tag += is_blank ? ' ' : static_cast<char>(letter >= 'A' && letter <= 'Z' ? letter - 'A' + 'a' : letter);
    if (letter == '>') break;
  }
  return tag;
}

bool is_markup(std::string_view text) {
  constexpr std::array<std::string_view, 4> tags = {"<svg", "<!doctype svg", "<!doctype html", "<html"};
  const std::string tag = first_tag(text);
  return std::any_of(tags.begin(), tags.end(), [&](std::string_view each) { return tag.starts_with(each); });
}

}  // namespace labmouse
