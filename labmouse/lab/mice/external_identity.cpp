#include "labmouse/lab/mice/external_identity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "labmouse/lab/text/former_names.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

/// A longer word is not a file name, but source code: the bridge to capstone robots.
constexpr std::size_t longest_word = 200;
/// Only so many bytes of a file are searched for names of files; the rest only counts for the hash.
constexpr std::size_t longest_text = std::size_t{16} << 20U;
/// Limit of files and folders to consider, more than a mouse has of its own.
constexpr std::size_t most_entries = 5'000;

/// FNV-1a, incremental.
class Hash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * 0x100000001B3U;
  }
  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

struct Content {
  std::string hash = "unread";
  std::string text;  ///< its beginning
};

Content content_of(const fs::path& file) {
  Content content;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return content;
  Hash hash;
  std::string piece(std::size_t{1} << 16U, '\0');
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0) {
    const std::string_view read(piece.data(), static_cast<std::size_t>(stream.gcount()));
    hash.add(read);
    if (content.text.size() < longest_text) content.text += read;
  }
  content.hash = hash.text();
  return content;
}

/// The file that a word names; empty if there is none. Programs in PATH do not count: they belong to the system.
fs::path file_of(const std::string& word, const std::string& directory) {
  std::error_code error;
  if (word.empty() || word.size() > longest_word) return {};
  const fs::path path = fs::path(directory) / word;
  return fs::is_regular_file(path, error) ? path : fs::path();
}

/// The files that a program may use: files beside it with the same extension; and files in its folder or subfolders
/// whose names occur in an included file. Without an extension, only names count.
class UsedFiles {
 public:
  explicit UsedFiles(const fs::path& file)
      : folder_(file.has_parent_path() ? file.parent_path() : fs::path(".")), ending_(file.extension().string()) {
    count(file);
    look_into(folder_);
    for (bool more = true; more;) more = count_named();
  }

  /// A line for each file, the program first: its path relative to the program's folder, and a hash of its content.
  const std::string& lines() const { return lines_; }

 private:
  void count(const fs::path& file) {
    Content content = content_of(file);
    lines_ += fmt::format("file {} {}\n", file.lexically_relative(folder_).generic_string(), content.hash);
    texts_.push_back(std::move(content.text));
    counted_.insert(file.lexically_normal());
  }

  void look_into(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> found;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      const std::string name = entry->path().filename().string();
      if (!name.starts_with('.') && name != "__pycache__") found.push_back(entry->path());
    }
    std::sort(found.begin(), found.end());
    for (const fs::path& path : found)
      if (waiting_.size() < most_entries) waiting_.push_back({path, 0});
  }

  /// Includes waiting files with the same extension or mentioned in included files; returns whether there were any.
  bool count_named() {
    std::vector<Waiting> before;
    before.swap(waiting_);
    const std::size_t known = lines_.size() + before.size();
    for (Waiting& each : before) {
      std::error_code error;
      if (counted_.count(each.path.lexically_normal()) > 0) continue;
      if (fs::is_directory(each.path, error)) {
        if (is_named(each))
          look_into(each.path);
        else
          waiting_.push_back(std::move(each));
      } else if (fs::is_regular_file(each.path, error)) {
        if ((!ending_.empty() && each.path.extension() == ending_) || is_named(each))
          count(each.path);
        else
          waiting_.push_back(std::move(each));
      }
    }
    return lines_.size() + waiting_.size() != known;
  }

  struct Waiting {
    fs::path path;
    std::size_t read = 0;  ///< number of texts already searched for its name
  };

  bool is_named(Waiting& each) const {
    const std::string name = each.path.filename().string();
    while (each.read < texts_.size())
      if (texts_[each.read++].find(name) != std::string::npos) return true;
    return false;
  }

  fs::path folder_;
  std::string ending_, lines_;
  std::vector<std::string> texts_;
  std::set<fs::path> counted_;
  std::vector<Waiting> waiting_;
};

std::string line_of(const Launch& launch, std::size_t word, const std::string& label) {
  const std::string& text = launch.words[word];
  // A first word without a slash is searched in PATH.
  const fs::path file = word == 0 && text.find('/') == std::string::npos ? fs::path() : file_of(text, launch.directory);
  if (file.empty()) return fmt::format("word {}\n", text.size() > longest_word ? hash_of(text) : text);
  if (!label.empty()) return fmt::format("file {}\n", file.filename().string());
  return UsedFiles(file).lines();
}

}  // namespace

std::string hash_of(std::string_view bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.text();
}

std::string program_identity(const std::string& path) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  return fmt::format("program {} {}\n", fs::path(path).filename().string(),
                     content_of(error ? fs::path(path) : real).hash);
}

std::string external_identity(std::string_view kind, const Launch& launch,
                              const std::optional<Interpreter>& interpreter, const std::string& label) {
  // The former word, so that existing stores stay valid.
  std::string text = fmt::format("guest {}\n", former_key(kind));
  if (!label.empty()) text += fmt::format("label {}\n", label);
  if (interpreter)
    text += fmt::format("interpreter {} {}\n", fs::path(interpreter->path).filename().string(), interpreter->version);
  // The first word is then the path of the interpreter, which does not matter.
  for (std::size_t word = interpreter ? 1 : 0; word < launch.words.size(); ++word) text += line_of(launch, word, label);
  for (const std::string& variable : launch.environment) text += fmt::format("variable {}\n", variable);
  const ExternalLimits& limits = launch.limits;
  text += fmt::format("limits {} {} {} {} {} {} {} {}\n", limits.start.count(), limits.decision.count(),
                      limits.silence.count(), limits.contest.count(), limits.processor_seconds, limits.memory,
                      limits.processes, limits.written);
  if (launch.sandbox && launch.keeps_folder) text += "keeps its folder\n";
  // This line differs from that of earlier versions, whose sandboxes allowed to read mazes and remember contests.
  return text + (launch.sandbox ? "sandbox with files of its own\n" : "sandbox no\n");
}

}  // namespace labmouse
