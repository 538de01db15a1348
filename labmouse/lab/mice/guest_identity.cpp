#include "labmouse/lab/mice/guest_identity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace labmouse {
namespace {

namespace fs = std::filesystem;

/// Of a longer file only the length counts: it is data, and no mouse.
constexpr std::uintmax_t longest_file = std::uintmax_t{64} << 20U;
/// A longer word is a program, not a name: the bridge to capstone robots.
constexpr std::size_t longest_word = 200;

std::string content_of(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (error) return "unread";
  if (size > longest_file) return fmt::format("{} bytes", size);
  std::ifstream stream(file, std::ios::binary);
  return hash_of(std::string(std::istreambuf_iterator<char>(stream), {}));
}

/// The file that a word names; empty where it names none. What is looked for in PATH belongs to the system.
fs::path file_of(const std::string& word, const std::string& directory) {
  std::error_code error;
  if (word.empty() || word.size() > longest_word) return {};
  const fs::path path = fs::path(directory) / word;
  return fs::is_regular_file(path, error) ? path : fs::path();
}

/// The files of the same ending in the folder of that file, itself among them, in the order of their names: what it may
/// import. A file without an ending stands alone.
std::vector<fs::path> kin_of(const fs::path& file) {
  std::vector<fs::path> kin = {file};
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end && file.has_extension();
       entry.increment(error))
    if (entry->path().extension() == file.extension() && entry->path().filename() != file.filename() &&
        entry->is_regular_file(error))
      kin.push_back(entry->path());
  std::sort(kin.begin() + 1, kin.end());
  return kin;
}

std::string line_of(const Launch& launch, std::size_t word, const std::string& label) {
  const std::string& text = launch.words[word];
  // The first word without a slash is looked for in PATH.
  const fs::path file = word == 0 && text.find('/') == std::string::npos ? fs::path() : file_of(text, launch.directory);
  if (file.empty()) return fmt::format("word {}\n", text.size() > longest_word ? hash_of(text) : text);
  if (!label.empty()) return fmt::format("file {}\n", file.filename().string());
  std::string lines;
  for (const fs::path& each : kin_of(file))
    lines += fmt::format("file {} {}\n", each.filename().string(), content_of(each));
  return lines;
}

}  // namespace

std::string hash_of(std::string_view bytes) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001B3U;
  return fmt::format("{:016x}", hash);
}

std::string guest_identity(std::string_view kind, const Launch& launch, const std::optional<Interpreter>& interpreter,
                           const std::string& label) {
  std::string text = fmt::format("guest {}\n", kind);
  if (!label.empty()) text += fmt::format("label {}\n", label);
  if (interpreter)
    text += fmt::format("interpreter {} {}\n", fs::path(interpreter->path).filename().string(), interpreter->version);
  // The interpreter's own place is the first word then.
  for (std::size_t word = interpreter ? 1 : 0; word < launch.words.size(); ++word) text += line_of(launch, word, label);
  for (const std::string& variable : launch.environment) text += fmt::format("variable {}\n", variable);
  const GuestLimits& limits = launch.limits;
  text += fmt::format("limits {} {} {} {} {} {} {} {}\n", limits.start.count(), limits.decision.count(),
                      limits.silence.count(), limits.contest.count(), limits.processor_seconds, limits.memory,
                      limits.processes, limits.written);
  if (launch.sandbox && launch.keeps_folder) text += "keeps its folder\n";
  // In the sandboxes of earlier versions, a mouse could read mazes and remember contests.
  return text + (launch.sandbox ? "sandbox with files of its own\n" : "sandbox no\n");
}

}  // namespace labmouse
