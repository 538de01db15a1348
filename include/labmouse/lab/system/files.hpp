// Reads and writes whole files, standard input and output, pipes and devices.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/text/text_sink.hpp"

namespace labmouse {

/// The content of a file, or an error.
struct FileContent {
  std::string content;  ///< empty if there is an error
  std::string error;    ///< without the path, such as "no such file"; empty on success
};

/// Reads all of a path that a user gave. Waits for the end of a pipe. The content of a stream is kept, so reading it
/// again gives the same.
/// @param path a file, a pipe, a device, or standard input as `-`.
/// @param most_bytes more bytes are an error.
/// @return the content; or the error, also for a folder, gzip, and text in UTF-16.
FileContent read_file(const std::string& path, std::size_t most_bytes = 1U << 20U);

/// Reads a file that was found in a folder or named in another file.
/// @param path a file; pipes and devices are an error, because they may never end.
/// @param most_bytes more bytes are an error.
/// @return as of read_file().
FileContent read_found_file(const std::string& path, std::size_t most_bytes = 1U << 20U);

/// Writes a file under another name in its folder and then renames it, so that nobody sees half of it. Creates missing
/// folders; follows links and keeps them. A stream is written directly. Under `ulimit -f` the program must ignore
/// SIGXFSZ, else that signal ends it.
/// @param path a file, a pipe, a device, or standard output as `-`.
/// @param content replaces what the file had.
/// @return the error with its cause, such as "cannot write: no space left on the device"; empty on success.
std::string write_file(const std::string& path, std::string_view content);
/// The same for a text that is produced in parts.
/// @param path as above.
/// @param content called once; not called if the path cannot be written. After an error, further parts are dropped.
/// @return as above.
std::string write_file(const std::string& path, const TextSource& content);

/// Whether two paths for writing lead to the same file: "x" and "./x", a link and its target. Standard output as `-`
/// and other descriptors are the same if their numbers are.
/// @param path as of write_file(); the file need not exist yet.
/// @param other as above.
bool is_same_file(const std::string& path, const std::string& other);

/// Whether write_file() could write there now. Creates missing folders, but leaves no file.
/// @param path as of write_file(). Named pipes and devices are not tried.
/// @return the error, as of write_file(); empty if it could.
std::string check_writable(const std::string& path);

}  // namespace labmouse
