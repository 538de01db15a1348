#include "labmouse/lab/mice_files/mice_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <regex>

#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/lab/text/toml_text.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> environments = {"venv", ".venv", "env", ".env"};
constexpr int deepest = 3;

bool has(const std::string& text, std::string_view word) { return text.find(word) != std::string::npos; }

/// The content of a file; empty if it is larger than 16 MiB.
std::string beginning_of(const fs::path& path) {
  constexpr std::size_t most = std::size_t{16} << 20U;
  std::error_code error;
  if (fs::file_size(path, error) > most || error) return "";
  return read_file(path.string(), most).content;
}

bool is_executable(const fs::path& path) {
  std::error_code error;
  return (fs::status(path, error).permissions() & fs::perms::owner_exec) != fs::perms::none;
}

/// Whether a text has syntax of Python 2 only. A line that begins with `print` and a word may be prose, so it counts
/// only if `print(` is not in the text.
bool is_python_2(const std::string& text) {
  constexpr std::size_t longest = 200;
  static const std::regex sure(
      R"([ \t]*(print[ \t]*(["'][^)]*|>>.*)|except[ \t][^:]*,[ \t]*\w+[ \t]*:.*|raise[ \t]+\w+[ \t]*,.*))");
  static const std::regex likely(R"([ \t]*print[ \t]+\w+[^(]*)");
  const bool calls = has(text, "print(");
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, std::min(end - begin, longest));
    if (std::regex_match(line, sure) || (!calls && std::regex_match(line, likely))) return true;
    begin = end + 1;
  }
  return false;
}

/// The kind of a file, and how uncertain the guess is: 0 is certain.
struct Guess {
  std::string kind, interpreter;
  int doubt = 0;
  bool old_python = false;
};

std::optional<Guess> guess_of(const fs::path& path) {
  const std::string name = path.filename().string(), ending = path.extension().string();
  const bool script = ending == ".py" || ending == ".js";
  if (!script && !is_executable(path)) return std::nullopt;
  const std::string text = beginning_of(path);
  if (!script &&
      !text.starts_with("\x7f"
                        "ELF") &&
      !text.starts_with("#!"))
    return std::nullopt;
  if (ending == ".py" && has(text, "class Robot") && has(text, "def next_move"))
    return Guess{"capstone", "", name == "robot.py" ? 0 : 1, is_python_2(text)};
  const std::string interpreter = ending == ".py" ? "python3" : ending == ".js" ? "node" : "";
  const bool main = name == "main.py" || name == "Main.py" || !script;
  if (has(text, "labmouse 1")) return Guess{"program", interpreter, 2, false};
  if (has(text, "labmouse pilot 1")) return Guess{"controller", interpreter, 2, false};
  // API.py only contains the protocol of mms; the mouse is another file beside it.
  const bool for_mms = has(text, "mazeWidth") || has(text, "moveForward");
  if (for_mms && name != "API.py" && name != "api.py")
    return Guess{"mms", interpreter, main ? 2 : 3, ending == ".py" && is_python_2(text)};
  // By its name alone: broken as it is, it is what somebody wants to be raced or graded.
  if (name == "robot.py") return Guess{"capstone", "", 4, is_python_2(text)};
  return std::nullopt;
}

bool is_skipped(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name.starts_with('.') || name == "node_modules" || name == "__pycache__" ||
         std::find(environments.begin(), environments.end(), name) != environments.end();
}

/// Whether a file or folder has a printable name, as mice files require.
bool can_be_named(const fs::path& path) {
  const std::string name = path.filename().string();
  return shown(name) == name;
}

/// The interpreter of a virtual environment in that folder.
std::string environment_in(const fs::path& folder) {
  std::error_code error;
  for (const std::string_view name : environments)
    if (const fs::path python = folder / name / "bin" / "python"; fs::exists(python, error)) return python.string();
  return "";
}

/// A file with its guess. Of equally certain guesses the one nearer to the top folder is preferred.
struct LikelyMouse {
  Guess guess;
  int depth = 0;
  fs::path path;

  friend bool operator<(const LikelyMouse& a, const LikelyMouse& b) {
    return std::tie(a.guess.doubt, a.depth, a.path) < std::tie(b.guess.doubt, b.depth, b.path);
  }
};

void collect(const fs::path& folder, int depth, std::vector<LikelyMouse>& likely) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, error)) {
    if (!can_be_named(entry.path())) continue;
    if (entry.is_directory(error) && !entry.is_symlink(error)) {
      if (depth < deepest && !is_skipped(entry.path())) collect(entry.path(), depth + 1, likely);
    } else if (entry.is_regular_file(error)) {
      if (auto guess = guess_of(entry.path())) likely.push_back({std::move(*guess), depth, entry.path()});
    }
  }
}

FoundMouse found(const std::string& name, const LikelyMouse& mouse_file, const fs::path& top, const fs::path& own,
                 const std::string& old_python) {
  FoundMouse mouse = {name, mouse_file.guess.kind, mouse_file.path.lexically_relative(top).string(),
                      mouse_file.guess.interpreter, ""};
  if (const std::string python = environment_in(own); !python.empty() && mouse_file.path.extension() == ".py")
    mouse.interpreter = fs::path(python).lexically_relative(top).string();
  else if (mouse_file.guess.old_python) {
    mouse.interpreter = old_python.empty() ? "python2" : old_python;
    mouse.remark = old_python.empty() ? "for Python 2, which is not in PATH: not tried" : "for Python 2";
    mouse.can_start = !old_python.empty();
  }
  return mouse;
}

/// A path as a word of a command: with `./` if it has no slash, and quoted if it has blanks.
std::string word(const std::string& path) {
  std::string here = path.find('/') == std::string::npos ? "./" : "";
  for (const char letter : path) here += letter == '"' ? std::string(R"(""")") : std::string(1, letter);
  return here.find(' ') == std::string::npos ? here : "\"" + here + "\"";
}

}  // namespace

std::vector<FoundMouse> scan_for_mice(const fs::path& folder, const std::string& old_python) {
  std::map<std::string, FoundMouse> mice;
  std::error_code error;
  std::vector<fs::directory_entry> entries;
  for (const auto& entry : fs::directory_iterator(folder, error)) entries.push_back(entry);
  // The order of the file system is undefined.
  std::sort(entries.begin(), entries.end());
  for (const fs::directory_entry& entry : entries) {
    if (!can_be_named(entry.path())) continue;
    const std::string file = entry.path().filename().string();
    if (entry.is_directory(error)) {
      if (is_skipped(entry.path())) continue;
      std::vector<LikelyMouse> likely;
      collect(entry.path(), 1, likely);
      const auto best = std::min_element(likely.begin(), likely.end());
      mice[file] = best == likely.end()
                       ? FoundMouse{file, "", "", "", "no robot.py, and no program that speaks to labmouse or mms"}
                       : found(file, *best, folder, entry.path(), old_python);
    } else if (entry.is_regular_file(error)) {
      if (const auto guess = guess_of(entry.path())) {
        std::string name = entry.path().stem().string();
        if (mice.contains(name) || fs::is_directory(folder / name, error)) name = file;
        mice[name] = found(name, {*guess, 0, entry.path()}, folder, folder, old_python);
      }
    }
  }
  std::vector<FoundMouse> all;
  for (auto& [name, mouse] : mice) all.push_back(std::move(mouse));
  return all;
}

std::string mice_file_text(const std::vector<FoundMouse>& mice) {
  std::string text = "# Mice for labmouse race --mice-file. Paths are seen from here.\n";
  for (const FoundMouse& mouse : mice) {
    if (mouse.kind.empty()) {
      text += fmt::format("\n# {}: {}\n", mouse.name, mouse.remark);
      continue;
    }
    const std::string off = mouse.can_start ? "" : "# ";
    text += mouse.remark.empty() ? "\n" : fmt::format("\n# {}\n", mouse.remark);
    text += fmt::format("{0}[[mouse]]\n{0}name = {1}\n", off, quoted_toml(mouse.name));
    const std::string folder = fs::path(mouse.file).parent_path().string();
    // A program runs in its own folder, and may not write to those of other mice.
    const bool moves = mouse.kind != "capstone" && !folder.empty();
    const std::string file = moves ? fs::path(mouse.file).filename().string() : mouse.file;
    text += fmt::format("{}{} = {}\n", off, mouse.kind, quoted_toml(mouse.kind == "capstone" ? file : word(file)));
    if (moves) text += fmt::format("{}directory = {}\n", off, quoted_toml(folder));
    if (!mouse.interpreter.empty()) text += fmt::format("{}interpreter = {}\n", off, quoted_toml(mouse.interpreter));
  }
  return text;
}

}  // namespace labmouse
