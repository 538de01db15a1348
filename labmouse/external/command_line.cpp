#include "labmouse/external/command_line.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace labmouse {
namespace {

bool is_blank(char letter) { return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r'; }

bool can_run(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

}  // namespace

std::vector<std::string> split_command(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  bool quoted = false, begun = false;
  const auto end_word = [&] {
    if (begun) words.push_back(std::move(word));
    word.clear();
    begun = false;
  };
  while (!text.empty()) {
    if (text.starts_with("\"\"\"")) {
      word += '"';
      begun = true;
      text.remove_prefix(3);
      continue;
    }
    if (text.front() == '"')
      quoted = !quoted;
    else if (!quoted && is_blank(text.front()))
      end_word();
    else
      word += text.front();
    begun = begun || quoted || !word.empty();
    text.remove_prefix(1);
  }
  end_word();
  return words;
}

bool has_open_quote(std::string_view text) {
  bool quoted = false;
  for (auto at = text.find('"'); at != std::string_view::npos; at = text.find('"', at)) {
    const bool letter = text.substr(at).starts_with("\"\"\"");
    if (!letter) quoted = !quoted;
    at += letter ? 3 : 1;
  }
  return quoted;
}

std::string program_path(std::string_view name, std::string_view directory) {
  namespace fs = std::filesystem;
  if (name.empty()) return "";
  if (name.find('/') != std::string_view::npos) return can_run(fs::path(directory) / name) ? std::string(name) : "";
  const char* variable = std::getenv("PATH");
  std::string_view folders = variable == nullptr ? "/usr/local/bin:/usr/bin:/bin" : variable;
  for (bool more = true; more;) {
    const auto colon = folders.find(':');
    std::error_code error;
    const fs::path path = fs::absolute(fs::path(folders.substr(0, colon)) / name, error);
    if (!error && can_run(path)) return path;
    more = colon != std::string_view::npos;
    if (more) folders.remove_prefix(colon + 1);
  }
  return "";
}

}  // namespace labmouse
