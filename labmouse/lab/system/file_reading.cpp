#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>

#include "labmouse/lab/system/calls.hpp"
#include "labmouse/lab/system/descriptor.hpp"
#include "labmouse/lab/system/file_problems.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/streams.hpp"
#include "labmouse/lab/text/encoding.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

FileContent unreadable(int error_number) {
  if (error_number == ENOENT) return {"", "no such file"};
  return {"", "cannot read: " + cause_of(error_number)};
}

FileContent too_large(std::size_t bytes, std::size_t most_bytes) {
  return {"", fmt::format("is too large: {} bytes, where at most {} are allowed", bytes, most_bytes)};
}

/// Reads the rest of a file. `expected` is a guess of its size in bytes.
FileContent read_all(int descriptor, std::size_t expected, std::size_t most_bytes) {
  constexpr std::size_t least = std::size_t{1} << 12U;
  std::string content(std::min(expected, most_bytes) + least, '\0');
  std::size_t size = 0;
  while (true) {
    const std::ptrdiff_t count = read_some(descriptor, content.data() + size, content.size() - size);
    if (count < 0) return unreadable(errno);
    size += static_cast<std::size_t>(count);
    if (size > most_bytes) return {"", fmt::format("is too large: more than {} bytes", most_bytes)};
    if (count == 0) break;
    if (size == content.size()) content.resize(2 * size);
  }
  content.resize(size);
  if (const std::string_view foreign = foreign_encoding(content); !foreign.empty()) return {"", std::string(foreign)};
  return {std::move(content), ""};
}

/// The content of streams by path, because a stream can be read once but a command may ask for it again.
struct Streams {
  std::mutex mutex;
  std::map<std::string, FileContent> contents;
};

FileContent read_stream(const std::string& path, int descriptor, std::size_t most_bytes) {
  static Streams streams;
  const std::lock_guard lock(streams.mutex);
  const std::string name = descriptor == standard_input ? "-" : path;
  auto known = streams.contents.find(name);
  if (known == streams.contents.end()) {
    // Opening a named pipe waits here until somebody opens it for writing.
    const Descriptor opened =
        descriptor >= 0 ? Descriptor::borrowed(descriptor) : Descriptor::opened(open_to_read(path));
    if (opened.number() < 0) return unreadable(errno);
    known = streams.contents.emplace(name, read_all(opened.number(), 0, most_bytes)).first;
  }
  const std::size_t size = known->second.content.size();
  return size > most_bytes ? too_large(size, most_bytes) : known->second;
}

FileContent read_regular(const std::string& path, std::size_t bytes, std::size_t most_bytes) {
  if (bytes > most_bytes) return too_large(bytes, most_bytes);
  const Descriptor opened = Descriptor::opened(open_to_read(path));
  return opened.number() < 0 ? unreadable(errno) : read_all(opened.number(), bytes, most_bytes);
}

FileContent read_path(const std::string& path, std::size_t most_bytes, bool streams) {
  if (path.empty()) return {"", "the path of the file is empty"};
  if (const auto descriptor = descriptor_to_read(path); descriptor && streams)
    return read_stream(path, *descriptor, most_bytes);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return unreadable(error ? error.value() : ENOENT);
  if (fs::is_directory(status)) return unreadable(EISDIR);
  if (fs::is_regular_file(status)) {
    const auto size = fs::file_size(path, error);
    return error ? unreadable(error.value()) : read_regular(path, static_cast<std::size_t>(size), most_bytes);
  }
  return streams ? read_stream(path, -1, most_bytes) : FileContent{"", "is a pipe or a device, not a regular file"};
}

}  // namespace

FileContent read_file(const std::string& path, std::size_t most_bytes) { return read_path(path, most_bytes, true); }

FileContent read_found_file(const std::string& path, std::size_t most_bytes) {
  return read_path(path, most_bytes, false);
}

}  // namespace labmouse
