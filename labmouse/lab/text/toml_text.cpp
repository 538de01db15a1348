#include "labmouse/lab/text/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

TomlText parse_toml(std::string_view text) {
  constexpr std::size_t most_bytes = std::size_t{1} << 16U;
  if (text.size() > most_bytes)
    return {{}, {{0, 0, fmt::format("is too large: {} bytes, where at most {} are allowed", text.size(), most_bytes)}}};
  toml::parse_result parsed = toml::parse(text);
  if (!parsed) return {{}, {problem_at(parsed.error().source().begin, shown(parsed.error().description()))}};
  return {std::move(parsed).table(), {}};
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
