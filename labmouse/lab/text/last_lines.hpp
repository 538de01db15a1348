// What a program wrote last to its standard error.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace labmouse {

/// How much of the texts of a run a race keeps.
inline constexpr std::size_t kept_error_lines = 5;  ///< of standard error, the last ones
inline constexpr std::size_t kept_text = 300;       ///< bytes of each

/// The last lines of what a program wrote to its standard error. Blank ones are left out, and those of nothing but ^
/// and ~, the marks in a traceback of Python.
std::vector<std::string> last_lines(std::string_view errors, std::size_t most = kept_error_lines);

}  // namespace labmouse
