#include "labmouse/maze/formats/text.hpp"

#include <algorithm>

#include "labmouse/functions/byte_order_mark.hpp"
#include "labmouse/functions/parse_number.hpp"

namespace labmouse::formats {
namespace {

constexpr std::string_view blanks_and_ends = " \t\r\n";

std::string_view without_last(std::string_view text, std::string_view letters) {
  return text.substr(0, text.find_last_not_of(letters) + 1);
}

// Takes the first line off the content.
std::string_view next_line(std::string_view& content) {
  const std::size_t length = content.find('\n');
  const std::string_view text = content.substr(0, length);
  content.remove_prefix(length == std::string_view::npos ? content.size() : length + 1);
  return without_last(text, " \t\r");
}

}  // namespace

bool is_blank(std::string_view content) {
  return without_mark(content).find_first_not_of(blanks_and_ends) == std::string_view::npos;
}

std::string_view first_line(std::string_view content) {
  content = without_mark(content);
  return next_line(content);
}

bool has_only_numbers(std::string_view line) {
  return line.find_first_not_of("0123456789-, \t") == std::string_view::npos &&
         line.find_first_of("0123456789") != std::string_view::npos;
}

std::vector<Line> lines_of(std::string_view content, std::size_t most) {
  content = without_last(without_mark(content), blanks_and_ends);
  std::vector<Line> lines;
  while (!content.empty() && lines.size() < most) {
    const int number = static_cast<int>(lines.size()) + 1;
    lines.push_back({number, next_line(content)});
  }
  return lines;
}

std::vector<Word> words_between_blanks(std::string_view text, std::size_t most) {
  std::vector<Word> words;
  std::size_t from = text.find_first_not_of(blanks);
  while (from != std::string_view::npos && words.size() < most) {
    const std::size_t to = std::min(text.find_first_of(blanks, from), text.size());
    words.push_back({text.substr(from, to - from), static_cast<int>(from) + 1});
    from = text.find_first_not_of(blanks, to);
  }
  return words;
}

std::vector<Word> words_between_commas(std::string_view text, std::size_t most) {
  std::vector<Word> words;
  std::size_t from = 0;
  while (from <= text.size() && words.size() < most) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::size_t first = std::min(text.find_first_not_of(blanks, from), to);
    words.push_back({without_last(text.substr(first, to - first), blanks), static_cast<int>(first) + 1});
    from = to + 1;
  }
  return words;
}

std::optional<int> number_of(std::string_view digits, int least, int most) {
  if (digits.starts_with('-')) return std::nullopt;  // -0 would be a number
  const auto number = parse_whole<int>(digits);
  return number && *number >= least && *number <= most ? number : std::nullopt;
}

}  // namespace labmouse::formats
