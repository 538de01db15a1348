// What an external mouse is, as far as that can be known without starting it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "labmouse/external/process.hpp"
#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse {

/// A text in lines that is another one where the external mouse may play otherwise: its words, its environment, its
/// limits, its interpreter's version, and what stands in the files that its words name, in the others of the same
/// ending beside these, and in files and folders there that such a file names. Folders do not count: the same files
/// elsewhere are the same external mouse. A `label` stands for all files, where it is not empty. Reads the files.
std::string external_identity(std::string_view kind, const Launch& launch,
                              const std::optional<Interpreter>& interpreter, const std::string& label);

/// The same of what runs an external mouse, in a line: the name and the content of the program at that path.
std::string program_identity(const std::string& path);

/// FNV-1a of the bytes, in hexadecimal digits.
std::string hash_of(std::string_view bytes);

}  // namespace labmouse
