#include "labmouse/lab/system/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace labmouse {

namespace fs = std::filesystem;

FileContent read_file(const std::string& path, std::size_t most_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return {"", "no such file"};
  if (error) return {"", "cannot be read: " + error.message()};
  if (!fs::is_regular_file(status)) return {"", "is not a file"};
  const auto bytes = fs::file_size(path, error);
  if (error) return {"", "cannot be read: " + error.message()};
  if (bytes > most_bytes) return {"", fmt::format("has {} bytes; more than {} is too large", bytes, most_bytes)};
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return {"", fmt::format("cannot be read: {}", std::generic_category().message(errno))};
  std::string content(bytes, '\0');
  if (!stream.read(content.data(), static_cast<std::streamsize>(bytes))) return {"", "cannot be read"};
  return {std::move(content), ""};
}

namespace {

/// Writes into what is no regular file (a device, a pipe), which must not be replaced.
std::string write_through(const std::string& path, std::string_view content) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  return stream ? "" : "cannot be written";
}

std::string beside(const fs::path& path) { return fmt::format("{}.{}.part", path.string(), getpid()); }

/// Writes a new file beside the place and puts it there in one move, with the permissions of the old one.
std::string replace(const fs::path& path, std::string_view content, const fs::file_status& old) {
  const std::string part = beside(path);
  std::error_code error;
  std::string problem = write_through(part, content);
  if (problem.empty() && fs::exists(old)) fs::permissions(part, old.permissions(), error);
  if (problem.empty() && !error) fs::rename(part, path, error);
  if (error) problem = "cannot be written: " + error.message();
  if (!problem.empty()) fs::remove(part, error);
  return problem;
}

/// Where a path leads, or why nothing can be written there.
struct Target {
  fs::path path;
  fs::file_status status;
  std::string error;

  /// A device or a pipe, which must not be replaced.
  bool lasting() const { return fs::exists(status) && !fs::is_regular_file(status); }
};

Target target_of(const std::string& path) {
  std::error_code error;
  if (const fs::path folder = fs::path(path).parent_path(); !folder.empty()) fs::create_directories(folder, error);
  if (error) return {{}, {}, "cannot make its folder: " + error.message()};
  // Through a link, so that the link stays and its target is what changes.
  const fs::path target = fs::weakly_canonical(path, error);
  if (error) return {{}, {}, "cannot be written: " + error.message()};
  const fs::file_status status = fs::status(target, error);
  return {target, status, fs::is_directory(status) ? "is a folder" : ""};
}

}  // namespace

std::string write_file(const std::string& path, std::string_view content) {
  const Target target = target_of(path);
  if (!target.error.empty()) return target.error;
  return target.lasting() ? write_through(path, content) : replace(target.path, content, target.status);
}

std::string check_writable(const std::string& path) {
  const Target target = target_of(path);
  if (!target.error.empty() || target.lasting()) return target.error;
  const std::string part = beside(target.path);
  std::string problem = write_through(part, "");
  std::error_code error;
  fs::remove(part, error);
  return problem;
}

}  // namespace labmouse
