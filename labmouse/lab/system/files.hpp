// Files, whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

/// The content of a file, or the reason why there is none.
struct FileContent {
  std::string content;
  std::string error;
};

/// Reads a whole file. One larger than most_bytes is refused before it is read.
FileContent read_file(const std::string& path, std::size_t most_bytes = 1U << 20U);

/// Writes a file beside its place and then renames it, so that nobody ever sees half of it; folders on the way are
/// made, links are followed, and what is no regular file (a device, a pipe) is written into. Returns what went wrong,
/// or nothing.
std::string write_file(const std::string& path, std::string_view content);

/// Whether write_file would write there now: makes the folders on the way and writes nothing that stays. Returns what
/// is wrong, or nothing.
std::string check_writable(const std::string& path);

}  // namespace labmouse
