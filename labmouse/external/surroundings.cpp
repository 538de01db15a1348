#include "labmouse/external/surroundings.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string_view>

#include "labmouse/external/command_line.hpp"
#include "labmouse/external/our_installation.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

constexpr std::array system_folders = {"/usr",    "/bin", "/sbin", "/lib", "/lib32", "/lib64",
                                       "/libx32", "/etc", "/opt",  "/nix", "/gnu"};
/// A longer word is not a file name but program text, such as the capstone bridge.
constexpr std::size_t longest_word = 200;

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

std::string environment_value(const Launch& launch, std::string_view name) {
  for (const std::string& variable : launch.environment)
    if (variable.size() > name.size() && variable.starts_with(name) && variable[name.size()] == '=')
      return variable.substr(name.size() + 1);
  const char* value = std::getenv(std::string(name).c_str());
  return value == nullptr ? "" : value;
}

/// The absolute path without `.` and `..`; links are not resolved.
std::string absolute(const fs::path& path, const fs::path& directory) {
  std::error_code error;
  std::string text = fs::absolute(directory / path, error).lexically_normal().string();
  while (text.size() > 1 && text.ends_with('/')) text.pop_back();
  return text;
}

bool is_of_the_system(std::string_view path) {
  return std::any_of(system_folders.begin(), system_folders.end(),
                     [&](const char* folder) { return lies_in(path, folder); });
}

/// Whether a folder is one for installed programs, by its name.
bool holds_programs(const fs::path& folder) {
  const fs::path name = folder.filename();
  return name == "bin" || name == "shims" || name == "sbin";
}

bool names_file(const std::string& word) {
  return !word.empty() && word.size() <= longest_word && word.find('\n') == std::string::npos;
}

/// Collects folders with the links that lead to them.
class Collection {
 public:
  explicit Collection(Surroundings& around) : around_(around) {}

  void add(const std::string& path) {
    if (!is_there(path)) return;
    const std::string real = follow(path);
    if (real != "/" && !real.empty()) visible_.insert(real);
  }

  /// Adds the links on a path, each with its final target. Returns the resolved path.
  std::string follow(const fs::path& path) {
    const fs::path whole = path.lexically_normal();
    fs::path done = "/";
    for (const fs::path& part : whole.relative_path()) {
      if (part.empty()) continue;
      std::error_code error;
      const fs::path next = done / part;
      done = fs::is_symlink(next, error) ? fs::canonical(next, error) : next;
      if (error) return "";
      if (done != next) links_.emplace(next.string(), done.string());
    }
    return done.string();
  }

  void finish() {
    for (const std::string& path : visible_)
      if ((around_.folder.empty() || !lies_in(path, around_.folder)) &&
          std::none_of(around_.visible.begin(), around_.visible.end(),
                       [&](const std::string& folder) { return lies_in(path, folder); }))
        around_.visible.push_back(path);
    // Links in a visible folder are visible already.
    for (const auto& link : links_)
      if (std::none_of(around_.visible.begin(), around_.visible.end(),
                       [&](const std::string& folder) { return lies_in(link.first, folder); }) &&
          (around_.folder.empty() || !lies_in(link.first, around_.folder)))
        around_.links.push_back(link);
  }

  const std::set<std::string>& collected() const { return visible_; }

 private:
  Surroundings& around_;
  std::set<std::string> visible_;
  std::set<std::pair<std::string, std::string>> links_;
};

/// The base folder of a Python virtual environment, from its pyvenv.cfg; empty if it is none.
std::string base_of_environment(const fs::path& environment) {
  std::ifstream file(environment / "pyvenv.cfg");
  for (std::string line; std::getline(file, line);)
    if (const auto equals = line.find('='); line.starts_with("home") && equals != std::string::npos) {
      const auto begin = line.find_first_not_of(' ', equals + 1);
      return begin == std::string::npos ? "" : line.substr(begin);
    }
  return "";
}

/// The program in the first line (`#!`) of a script; empty if there is none.
std::string program_of_script(const std::string& path) {
  std::array<char, 256> bytes{};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  std::string_view line(bytes.data(), static_cast<std::size_t>(file.gcount()));
  if (!line.starts_with("#!")) return "";
  const std::vector<std::string> words = split_command(line.substr(2, line.find('\n') - 2));
  if (words.empty()) return "";
  if (words.size() > 1 && fs::path(words[0]).filename() == "env") return program_path(words[1], "");
  return words[0];
}

/// Adds a program with its installation: the libraries beside it, and the base of a virtual environment. A file of a
/// mouse that names a program which is not there makes no folder visible.
void add_program(const std::string& path, Collection& all, int depth = 0) {
  constexpr int deepest = 6;
  std::error_code error;
  if (path.empty() || path.front() != '/' || depth > deepest || !fs::is_regular_file(path, error)) return;
  const char* home = std::getenv("HOME");
  const fs::path folder = fs::path(path).parent_path(), prefix = folder.parent_path();
  if (!holds_programs(folder) || prefix == "/" || (home != nullptr && lies_in(home, prefix.string()))) {
    all.add(path);
  } else {
    all.add(prefix == fs::path(home == nullptr ? "/" : home) / ".local" ? folder.string() : prefix.string());
    const std::string base = base_of_environment(prefix);
    if (!base.empty()) add_program((fs::path(base) / fs::path(path).filename()).string(), all, depth + 1);
  }
  const std::string real = fs::canonical(path, error).string();
  if (!error && real != path)
    add_program(real, all, depth + 1);
  else
    add_program(program_of_script(path), all, depth + 1);
}

/// The folders in a list such as PYTHONPATH.
std::vector<std::string> listed(const std::string& list, const std::string& directory) {
  std::vector<std::string> folders;
  for (std::string_view rest = list; !rest.empty();) {
    const std::string_view each = rest.substr(0, rest.find(':'));
    if (!each.empty()) folders.push_back(absolute(each, directory));
    rest.remove_prefix(std::min(rest.size(), each.size() + 1));
  }
  return folders;
}

/// Adds the node_modules of a folder and of those above it, from which Node imports.
void add_node_modules(const std::string& folder, Collection& all) {
  for (fs::path each = folder; each.has_relative_path(); each = each.parent_path()) {
    all.add((each / "node_modules").string());
    if (is_there(each / "node_modules")) all.add((each / "package.json").string());
  }
}

}  // namespace

bool lies_in(std::string_view path, std::string_view folder) {
  if (folder == "/") return true;
  return !folder.empty() && path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/');
}

std::string folder_of(const Launch& launch, const std::string& program) {
  std::error_code error;
  const std::string start = absolute(launch.directory, fs::current_path(error));
  std::string folder = start;
  for (std::size_t i = 0; i < launch.words.size() && !launch.owns_directory; ++i) {
    const std::string& word = i == 0 ? program : launch.words[i];
    if (!names_file(word)) continue;
    const std::string file = absolute(word, start);
    // An installed interpreter is not the mouse's own file.
    if (i == 0 && holds_programs(fs::path(file).parent_path())) continue;
    if (!fs::is_regular_file(file, error) || is_of_the_system(fs::canonical(file, error).string())) continue;
    folder = fs::path(file).parent_path().string();
    break;
  }
  const fs::path real = fs::canonical(folder, error);
  // A missing folder is reported when the external mouse starts.
  return error ? folder : real.string();
}

Surroundings surroundings_of(const Launch& launch, const std::string& program) {
  Surroundings around;
  std::error_code error;
  const std::string here = fs::current_path(error).string();
  const std::string start = absolute(launch.directory, here);
  around.folder = folder_of(launch, program);
  if (around.folder == "/") around.folder.clear();
  Collection all(around);
  around.directory = is_folder(start) ? all.follow(start) : start;
  for (const char* folder : system_folders) all.add(folder);
  add_program(absolute(program, start), all);
  for (const std::string& word : launch.words) {
    if (!names_file(word) || word == launch.words.front()) continue;
    const std::string path = absolute(word, start);
    // A word such as the root or a home folder does not make all of it visible.
    if (!lies_in(start, path)) around.named.push_back(path);
  }
  for (const char* name : {"PYTHONPATH", "NODE_PATH"})
    for (const std::string& folder : listed(environment_value(launch, name), start)) around.named.push_back(folder);
  for (const std::string& path : around.named) all.add(path);
  std::erase_if(around.named, [](const std::string& path) { return !is_folder(path); });
  for (const char* name : {"LD_LIBRARY_PATH", "PYTHONHOME", "PYENV_ROOT", "NVM_DIR"})
    for (const std::string& folder : listed(environment_value(launch, name), start)) all.add(folder);
  if (const char* home = std::getenv("HOME"); home != nullptr)
    for (const std::string& packages : matches_of(std::string(home) + "/.local/lib/python*")) all.add(packages);
  if (!around.folder.empty()) add_node_modules(around.folder, all);
  all.finish();
  around.hidden = seen_of(around, our_installation(all.collected(), around.folder));
  return around;
}

std::vector<std::string> seen_of(const Surroundings& around, const std::vector<std::string>& paths) {
  std::vector<std::string> seen;
  for (const std::string& path : paths)
    if ((!around.folder.empty() && lies_in(path, around.folder) && path != around.folder) ||
        std::any_of(around.visible.begin(), around.visible.end(),
                    [&](const std::string& folder) { return lies_in(path, folder); }))
      seen.push_back(path);
  return seen;
}

}  // namespace labmouse
