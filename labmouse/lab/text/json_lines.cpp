#include "labmouse/lab/text/json_lines.hpp"

#include <algorithm>

#include "labmouse/functions/byte_order_mark.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_problem.hpp"

namespace labmouse {
namespace {

/// Removes the first line from the text and returns it.
std::string_view next_line(std::string_view& text) {
  const auto length = text.find('\n');
  const auto line = text.substr(0, length);
  text.remove_prefix(length == std::string_view::npos ? text.size() : length + 1);
  return line;
}

}  // namespace

std::vector<Problem> read_json_lines(std::string_view text, const LineReader& reader) {
  text = without_mark(text);
  const bool last_is_whole = text.ends_with('\n');
  bool empty = true;
  for (int number = 1; !text.empty(); ++number) {
    const auto line = next_line(text);
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    const ReadJson json = read_json(line);
    if (json.is_discarded() && !empty && text.empty() && !last_is_whole && reader.may_break_off()) break;
    if (json.is_discarded()) {
      const Problem problem = json_problem(line);
      return {{number, std::max(problem.column, 1), "the line is " + problem.reason}};
    }
    if (auto error = empty ? reader.header(json) : reader.line(json); !error.empty())
      return {{number, 1, std::move(error)}};
    empty = false;
  }
  if (empty) return {{0, 0, "the record is empty"}};
  return {};
}

}  // namespace labmouse
