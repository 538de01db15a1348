// Quotes output of an external mouse for messages, with invisible characters escaped.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

/// The beginning of a line in quotation marks, as printable ASCII: a tab as \t, other bytes as \xNN. A byte-order mark
/// and a carriage return at the end are explained: "'\ufeffmove 0 1' (it begins with a byte-order mark)".
std::string quoted_line(std::string_view line);

}  // namespace labmouse
