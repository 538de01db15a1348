// Files, whole or not at all, and what stands in their place: standard input and output, pipes, devices.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/text/text_sink.hpp"

namespace labmouse {

/// The content of a file, or the reason why there is none.
struct FileContent {
  std::string content;
  std::string error;
};

/// Reads all of what a user named: a file, a pipe, or standard input as `-`. What has more than most_bytes is refused,
/// and so is what is not text as we read it (foreign_encoding). Whatever is not a regular file can be read just once:
/// its content is kept, and asked for again it is the same.
FileContent read_file(const std::string& path, std::size_t most_bytes = 1U << 20U);

/// Reads a file that was found, in a folder or in the words of another file, and so may be no pipe that nobody writes.
FileContent read_found_file(const std::string& path, std::size_t most_bytes = 1U << 20U);

/// Writes a file beside its place and then renames it, so that nobody ever sees half of it; folders on the way are
/// made, links are followed and stay. What is no regular file is written into: a pipe, a device, standard output as
/// `-`. Returns what went wrong with its cause, "cannot be written: no space is left on the device", or nothing.
/// Under `ulimit -f` that takes a program that ignores SIGXFSZ.
std::string write_file(const std::string& path, std::string_view content);
/// The same of a text that is made part by part.
std::string write_file(const std::string& path, const TextSource& content);

/// Whether two paths lead to one file, which need not exist yet: "x" and "./x", links and their targets. Of streams: to
/// one descriptor.
bool is_same_file(const std::string& path, const std::string& other);

/// Whether write_file would write there now: makes the folders on the way and writes nothing that stays. Returns what
/// is wrong, or nothing.
std::string check_writable(const std::string& path);

}  // namespace labmouse
