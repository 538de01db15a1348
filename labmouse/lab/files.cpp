#include "labmouse/lab/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace labmouse {

namespace fs = std::filesystem;

FileContent read_file(const std::string& path, std::size_t most_bytes) {
  std::error_code error;
  if (!fs::exists(path, error)) return {"", "no such file"};
  if (!fs::is_regular_file(path, error)) return {"", "is not a file"};
  const auto bytes = fs::file_size(path, error);
  if (error) return {"", "cannot be read: " + error.message()};
  if (bytes > most_bytes) return {"", fmt::format("has {} bytes; more than {} is too large", bytes, most_bytes)};
  std::ifstream stream(path, std::ios::binary);
  std::string content(bytes, '\0');
  if (!stream.read(content.data(), static_cast<std::streamsize>(bytes))) return {"", "cannot be read"};
  return {std::move(content), ""};
}

std::string write_file(const std::string& path, std::string_view content) {
  std::error_code error;
  if (const fs::path folder = fs::path(path).parent_path(); !folder.empty()) fs::create_directories(folder, error);
  if (error) return "cannot make its folder: " + error.message();
  const std::string beside = fmt::format("{}.{}.part", path, getpid());
  std::ofstream stream(beside, std::ios::binary | std::ios::trunc);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) {
    fs::remove(beside, error);
    return "cannot be written";
  }
  fs::rename(beside, path, error);
  if (!error) return "";
  std::error_code ignored;
  fs::remove(beside, ignored);
  return "cannot be written: " + error.message();
}

}  // namespace labmouse
