// The kind of a file, found from its text. Messages name it when a user passes the wrong file.
#pragma once

#include <cstdint>
#include <string_view>

namespace labmouse {

enum class FileKind : std::uint8_t { unknown, maze, record, results, csv, page };

/// The kind of a file of labmouse, or FileKind::unknown. It may still be damaged.
FileKind kind_of_file(std::string_view text);

}  // namespace labmouse
