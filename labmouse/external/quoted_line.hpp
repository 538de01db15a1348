// What an external mouse wrote, quoted so that what is wrong with it shows.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

/// The beginning of a line in quotation marks, as printable ASCII: a tab as \t, a byte that is no such letter as \xNN.
/// What is easily overlooked is said behind it: "'\ufeffmove 0 1' (it begins with a byte-order mark)".
std::string quoted_line(std::string_view line);

}  // namespace labmouse
