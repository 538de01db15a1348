#include "labmouse/lab/text/json_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/numbers.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// A parser's handler that accepts everything and keeps the position and message of the first error.
class Mistake final : public nlohmann::json_sax<ReadJson> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
    bytes = position;
    words = error.what();
    return false;
  }

  std::size_t bytes = 0;  ///< bytes read up to the error
  std::string words;
};

/// The parser's message "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ..." without
/// its prefix.
std::string without_place(const std::string& words) {
  const auto place = words.find(": ");
  const auto mark = words.find("] ");
  if (words.find("parse error at line") != std::string::npos && place != std::string::npos)
    return words.substr(place + 2);
  return mark == std::string::npos ? words : words.substr(mark + 2);
}

/// A problem at the position after these bytes.
Problem problem_behind(std::string_view before, std::string reason) {
  const auto line_begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
          static_cast<int>(before.size() - line_begin) + 1, "not valid JSON: " + std::move(reason)};
}

}  // namespace

Problem json_problem(std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == text.npos) return {1, 1, "not valid JSON: it is empty"};
  if (is_too_deep(text))
    return {0, 0, fmt::format("not valid JSON: its lists and objects are nested more than {} deep", most_json_depth)};
  const std::string_view number = bad_json_number(text);
  const std::string_view before = text.substr(0, static_cast<std::size_t>(number.data() - text.data()));
  Mistake mistake;
  // A bad number may come before or after another error; report the first of both.
  const bool parsed = ReadJson::sax_parse(text, &mistake);
  if (!number.empty() && (parsed || before.size() < mistake.bytes)) {
    constexpr std::size_t longest = 40;
    const std::string words = shown(number.substr(0, longest)) + (number.size() > longest ? "..." : "");
    return problem_behind(before, fmt::format("'{}' {}", words, why_no_number(number)));
  }
  if (parsed) return {0, 0, "it is JSON"};
  return problem_behind(text.substr(0, mistake.bytes == 0 ? 0 : std::min(mistake.bytes - 1, text.size())),
                        without_place(mistake.words));
}

}  // namespace labmouse
