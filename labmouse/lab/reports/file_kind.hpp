// What a file is, by its text: for messages to a user who named another file than was meant.
#pragma once

#include <cstdint>
#include <string_view>

namespace labmouse {

enum class FileKind : std::uint8_t { unknown, maze, record, results, csv, page };

/// The kind of a file of labmouse, or FileKind::unknown. It may still be damaged.
FileKind kind_of_file(std::string_view text);

}  // namespace labmouse
