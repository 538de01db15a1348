// Reads and writes whole files, standard input and output, pipes and devices.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/text/text_sink.hpp"

namespace labmouse {

/// The content of a file, or an error.
struct FileContent {
  std::string content;
  std::string error;
};

/// Reads all of a path that a user gave: a file, a pipe, or standard input as `-`. Refuses more than `most_bytes` bytes
/// and text in a foreign encoding (foreign_encoding). The content of a stream is kept, so reading it again gives the
/// same.
FileContent read_file(const std::string& path, std::size_t most_bytes = 1U << 20U);

/// Reads a file that was found in a folder or named in another file. Refuses pipes and devices, which may never end.
FileContent read_found_file(const std::string& path, std::size_t most_bytes = 1U << 20U);

/// Writes a file under another name in its folder and then renames it, so that nobody sees half of it. Creates missing
/// folders; follows links and keeps them. A stream is written directly: a pipe, a device, or standard output as `-`.
/// Returns the error with its cause, such as "cannot write: no space left on the device", or nothing. Under `ulimit -f`
/// the program must ignore SIGXFSZ, else that signal ends it.
std::string write_file(const std::string& path, std::string_view content);
/// The same for a text that is produced in parts.
std::string write_file(const std::string& path, const TextSource& content);

/// Whether two paths lead to the same file, which need not exist yet: "x" and "./x", a link and its target. Streams are
/// the same if their descriptors are.
bool is_same_file(const std::string& path, const std::string& other);

/// Whether write_file() could write there now. Creates missing folders, but leaves no file. Returns what is wrong, or
/// nothing.
std::string check_writable(const std::string& path);

}  // namespace labmouse
