#include "labmouse/lab/page/json_problem.hpp"

#include <algorithm>

#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

/// Lets everything pass but a mistake, of which it keeps the place and the parser's words.
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

  std::size_t bytes = 0;  ///< read up to the mistake
  std::string words;
};

/// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ..." without what stands before.
std::string without_place(const std::string& words) {
  const auto place = words.find(": ");
  const auto mark = words.find("] ");
  if (words.find("parse error at line") != std::string::npos && place != std::string::npos)
    return words.substr(place + 2);
  return mark == std::string::npos ? words : words.substr(mark + 2);
}

}  // namespace

Problem json_problem(std::string_view text) {
  Mistake mistake;
  if (ReadJson::sax_parse(text, &mistake)) return {0, 0, "it is JSON"};
  const std::string_view before = text.substr(0, mistake.bytes == 0 ? 0 : std::min(mistake.bytes - 1, text.size()));
  const auto line_begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
          static_cast<int>(before.size() - line_begin) + 1, "not valid JSON: " + without_place(mistake.words)};
}

}  // namespace labmouse
