// Texts of JSON Lines, as records are: one object a line.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/text/json.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// What reads the lines of a text.
struct LineReader {
  /// Take the first line, and each of the others; return what is wrong with it, or nothing.
  std::function<std::string(const ReadJson&)> header, line;
  /// Whether the text may break off: then a last line that was cut, say when the power went off, counts for nothing.
  std::function<bool()> may_break_off;
};

/// Hands each line to the reader, without blank ones and a byte order mark in front. Returns what is wrong with the
/// first bad line, or with a text that has none; nothing where all is well.
std::vector<Problem> read_json_lines(std::string_view text, const LineReader& reader);

}  // namespace labmouse
