// Messages compared by what matters in them, so that a test does not break over another wording.
#pragma once

#include <gmock/gmock.h>

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace labmouse::test {

/// Whether a text has that part. A number at an end of the part is a whole one: "5" is no part of "15" or "5.2".
inline bool has_part(std::string_view text, std::string_view part) {
  const auto digit = [](std::string_view in, std::size_t at) {
    return at < in.size() && std::isdigit(static_cast<unsigned char>(in[at])) != 0;
  };
  const auto behind_number = [&](std::size_t at) {  // 0 - 1 is no place in a text
    return digit(text, at - 1) || (text.substr(0, at).ends_with('.') && digit(text, at - 2));
  };
  const auto before_number = [&](std::size_t at) {
    return digit(text, at) || (text.substr(at).starts_with('.') && digit(text, at + 1));
  };
  for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) {
    const bool cut =
        (digit(part, 0) && behind_number(at)) || (digit(part, part.size() - 1) && before_number(at + part.size()));
    if (!cut) return true;
  }
  return false;
}

MATCHER_P(HasParts, parts, std::string(negation ? "lacks one of " : "has all of ") + testing::PrintToString(parts)) {
  const std::string_view text = arg;
  bool all = true;
  for (const std::string& part : parts) {
    if (has_part(text, part)) continue;
    *result_listener << (all ? "which lacks " : ", ") << testing::PrintToString(part);
    all = false;
  }
  return all;
}

/// A text with all of these parts in it, in any order and in whatever words.
template <typename... Parts>
auto Says(Parts... parts) {
  return HasParts(std::vector<std::string>{std::string(parts)...});
}

/// The same of a message that begins with its place, such as "2:5", "bad.txt:2:5" or "run 1 (search)".
template <typename... Parts>
auto SaysAt(const std::string& place, Parts... parts) {
  return testing::AllOf(testing::StartsWith(place + ": "), Says(parts...));
}

MATCHER_P3(IsProblem, line, column, parts,
           "is at " + testing::PrintToString(line) + ":" + testing::PrintToString(column) + " and has all of " +
               testing::PrintToString(parts)) {
  *result_listener << "at " << arg.line << ":" << arg.column << ": " << testing::PrintToString(arg.reason) << " ";
  return arg.line == line && arg.column == column &&
         testing::ExplainMatchResult(HasParts(parts), arg.reason, result_listener);
}

/// A Problem in that line and column whose reason has all of these parts in it.
template <typename... Parts>
auto ProblemAt(int line, int column, Parts... parts) {
  return IsProblem(line, column, std::vector<std::string>{std::string(parts)...});
}

}  // namespace labmouse::test
