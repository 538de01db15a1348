#include "labmouse/lab/text/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {
namespace {

/// A hint where a line gives a key a word such as "yes", which other formats use for true or false.
std::string_view word_hint(std::string_view text, std::size_t line) {
  for (; line > 1 && !text.empty(); --line) text.remove_prefix(std::min(text.size(), text.find('\n') + 1));
  text = text.substr(0, text.find_first_of("\r\n#"));
  const std::size_t equals = text.find('=');
  if (equals == text.npos) return "";
  text.remove_prefix(equals + 1);
  const std::size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
  if (begin == text.npos) return "";
  const std::string_view word = text.substr(begin, end - begin + 1);
  if (word == "no" || word == "off" || word == "False") return "; write false";
  return word == "yes" || word == "on" || word == "True" ? "; write true" : "";
}

/// Whether a number that was read as 0 has other digits in the text.
bool is_not_written_as_zero(std::string_view text, toml::source_position place) {
  for (; place.line > 1; --place.line) text.remove_prefix(std::min(text.size(), text.find('\n') + 1));
  // Columns count characters; a character begins with a byte that is no UTF-8 continuation byte.
  const auto continues = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; };
  for (std::size_t left = place.column - 1; !text.empty() && (left > 0 || continues(text.front()));) {
    text.remove_prefix(1);
    if (text.empty() || !continues(text.front())) --left;
  }
  return text.substr(0, text.find_first_not_of("+-_.0123456789")).find_first_of("123456789") != text.npos;
}

/// The first number that is too small for a double. Infinities are out of range for every key.
std::optional<Problem> bad_number(const toml::node& node, std::string_view text) {
  if (const auto* number = node.as_floating_point()) {
    const int kind = std::fpclassify(number->get());
    const toml::source_position place = node.source().begin;
    if (kind == FP_SUBNORMAL || (kind == FP_ZERO && is_not_written_as_zero(text, place)))
      return problem_at(place, "this number is too small; write 0");
    return std::nullopt;
  }
  std::optional<Problem> problem;
  if (const auto* table = node.as_table())
    for (const auto& [key, value] : *table)
      if (!problem) problem = bad_number(value, text);
  if (const auto* array = node.as_array())
    for (const toml::node& value : *array)
      if (!problem) problem = bad_number(value, text);
  return problem;
}

}  // namespace

TomlText parse_toml(std::string_view text) {
  constexpr std::size_t most_bytes = std::size_t{1} << 16U;
  if (text.size() > most_bytes)
    return {{}, {{0, 0, fmt::format("is too large: {} bytes, where at most {} are allowed", text.size(), most_bytes)}}};
  toml::parse_result parsed = toml::parse(text);
  if (!parsed) {
    const toml::source_position place = parsed.error().source().begin;
    return {{}, {problem_at(place, shown(parsed.error().description()) + std::string(word_hint(text, place.line)))}};
  }
  if (auto problem = bad_number(parsed.table(), text)) return {{}, {*std::move(problem)}};
  return {std::move(parsed).table(), {}};
}

std::string quoted_toml(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + "\"";
}

Problem problem_at(const toml::source_position& place, std::string reason) {
  return {static_cast<int>(place.line), static_cast<int>(place.column), std::move(reason)};
}

std::vector<Problem> in_order(std::vector<Problem> problems) {
  std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  if (problems.size() > most_problems) problems.resize(most_problems);
  return problems;
}

std::string unknown_key(const std::string& name, std::span<const std::string_view> known) {
  const std::string_view near = nearest_name(name, known);
  return fmt::format("unknown key {}{}", formats::quoted(name),
                     near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
}

}  // namespace labmouse
