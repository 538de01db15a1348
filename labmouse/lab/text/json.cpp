#include "labmouse/lab/text/json.hpp"

#include <algorithm>

#include "labmouse/functions/parse_number.hpp"

namespace labmouse {

bool is_too_deep(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size() && depth <= most_json_depth; ++i) {
    const char letter = text[i];
    if (quoted && letter == '\\') ++i;
    if (letter == '"') quoted = !quoted;
    if (quoted) continue;
    if (letter == '[' || letter == '{') ++depth;
    if (letter == ']' || letter == '}') --depth;
  }
  return depth > most_json_depth;
}

std::string_view bad_json_number(std::string_view text) {
  // Only such numbers can be out of the range of a double.
  const auto may_be_bad = [](std::string_view number) {
    constexpr std::size_t long_number = 300;
    return number.size() > long_number || number.find_first_of("eE") != std::string_view::npos;
  };
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (quoted && letter == '\\') ++i;
    if (letter == '"') quoted = !quoted;
    if (quoted || (letter != '-' && (letter < '0' || letter > '9'))) continue;
    const auto end = std::min(text.find_first_not_of("0123456789+-.eE", i), text.size());
    const std::string_view number = text.substr(i, end - i);
    double value = 0.0;
    const NumberProblem problem = may_be_bad(number) ? parse_number(number, value) : NumberProblem::none;
    // The parser itself reports a text that is no number.
    if (problem != NumberProblem::none && problem != NumberProblem::no_number) return number;
    i = end - 1;
  }
  return text.substr(text.size());
}

namespace {

template <class Tree>
Tree read(std::string_view text) {
  if (is_too_deep(text) || !bad_json_number(text).empty()) return Tree(Tree::value_t::discarded);
  return Tree::parse(text, nullptr, false);
}

}  // namespace

ReadJson read_json(std::string_view text) { return read<ReadJson>(text); }
Json read_ordered_json(std::string_view text) { return read<Json>(text); }

std::string one_line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace labmouse
