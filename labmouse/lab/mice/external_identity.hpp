// Identifies an external mouse, by its command and files, without starting it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "labmouse/external/process.hpp"
#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse {

/// A text that changes whenever the mouse may behave differently: command, environment, limits, interpreter version,
/// and hashes of files. Included are the files named in the command, files beside them with the same extension, and
/// files and folders there that an included file mentions. The location does not matter: the same files in another
/// folder are the same mouse. A `label` that is not empty replaces all hashes. Reads the files.
std::string external_identity(std::string_view kind, const Launch& launch,
                              const std::optional<Interpreter>& interpreter, const std::string& label);

/// A line with name and hash of the program at that path, which runs an external mouse.
std::string program_identity(const std::string& path);

/// FNV-1a of the bytes, in hexadecimal digits.
std::string hash_of(std::string_view bytes);

}  // namespace labmouse
