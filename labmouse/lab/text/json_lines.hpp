// Reads JSON Lines, the format of records: one object in each line.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/text/json.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// Callbacks that read the lines.
struct LineReader {
  /// Read the first line, and each later line; return the error, or nothing.
  std::function<std::string(const ReadJson&)> header, line;
  /// Whether the text may end early. If so, an incomplete last line is ignored, such as one cut by a power failure.
  std::function<bool()> may_break_off;
};

/// Passes each line to the reader, without blank lines and an initial byte order mark. Returns the problem of the first
/// bad line, or of an empty text; nothing on success.
std::vector<Problem> read_json_lines(std::string_view text, const LineReader& reader);

}  // namespace labmouse
