#include "labmouse/lab/text/last_lines.hpp"

#include <algorithm>

namespace labmouse {
namespace {

/// Whether a line has content: not only blanks, or the ^ and ~ marks of a Python traceback.
bool says_something(std::string_view line) { return line.find_first_not_of(" \t\r^~") != std::string_view::npos; }

}  // namespace

std::vector<std::string> last_lines(std::string_view errors, std::size_t most) {
  std::vector<std::string> lines;
  while (!errors.empty() && lines.size() < most) {
    const auto end = errors.rfind('\n');
    const std::string_view line = end == std::string_view::npos ? errors : errors.substr(end + 1);
    if (says_something(line)) lines.emplace_back(line.substr(0, kept_text));
    errors = end == std::string_view::npos ? std::string_view() : errors.substr(0, end);
  }
  std::reverse(lines.begin(), lines.end());
  return lines;
}

}  // namespace labmouse
