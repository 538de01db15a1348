// A command as users write it: words, and the program that the first one names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace labmouse {

/// The words of a command as mms splits it: at blanks, except between double quotes; three quotes in a row are one of
/// the word's own. No shell: no variables, no redirection. Empty where there is no word.
std::vector<std::string> split_command(std::string_view text);

/// Whether a command ends between double quotes, so that its last word may not be all that was meant.
bool has_open_quote(std::string_view text);

/// The path of a program that can be executed: a name with a slash is taken as it is, seen from `directory` (empty:
/// from here); another is looked for in PATH. Empty where there is none.
std::string program_path(std::string_view name, std::string_view directory);

}  // namespace labmouse
