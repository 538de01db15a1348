#include "labmouse/lab/system/streams.hpp"

#include <filesystem>
#include <optional>
#include <string_view>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/system/calls.hpp"

namespace labmouse {
namespace {

/// N of `/dev/fd/N` and `/proc/self/fd/N`.
std::optional<int> numbered(std::string_view path) {
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const std::optional<int> number = parse_whole<int>(path.substr(folder.size()));
    if (number && *number >= 0) return number;
  }
  return std::nullopt;
}

}  // namespace

std::optional<int> descriptor_to_read(const std::string& path) {
  if (path == "-" || path == "/dev/stdin") return standard_input;
  return numbered(path);
}

std::optional<int> descriptor_to_write(const std::string& path) {
  if (path == "-" || path == "/dev/stdout") return standard_output;
  if (path == "/dev/stderr") return standard_error;
  return numbered(path);
}

bool is_stream(const std::string& path) {
  if (descriptor_to_write(path)) return true;
  std::error_code unknown;
  return std::filesystem::is_other(path, unknown);
}

}  // namespace labmouse
