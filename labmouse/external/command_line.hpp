// Parses a command as users write it: splits it into words, and finds the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace labmouse {

/// The words of a command as mms splits it: at blanks, except between double quotes; three double quotes in a row are
/// one literal quote. It is no shell: no variables, no redirection. Empty if there is no word.
std::vector<std::string> split_command(std::string_view text);

/// Whether a double quote is not closed, so that the last word may be incomplete.
bool has_open_quote(std::string_view text);

/// The path of an executable program. A name with a slash is relative to `directory` (empty: the current one); another
/// is searched in PATH. Empty if there is none.
std::string program_path(std::string_view name, std::string_view directory);

}  // namespace labmouse
