// The last lines of a program's standard error.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace labmouse {

/// Limits of the texts that a race keeps.
inline constexpr std::size_t kept_error_lines = 5;  ///< last lines of standard error
inline constexpr std::size_t kept_text = 300;       ///< bytes of each line

/// The last lines of standard error. Leaves out blank lines, and lines of ^ and ~ only, which mark positions in a
/// Python traceback.
std::vector<std::string> last_lines(std::string_view errors, std::size_t most = kept_error_lines);

}  // namespace labmouse
