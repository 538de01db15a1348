#include "labmouse/lab/system/file_names.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

namespace labmouse {
namespace {

/// A name as one part of a path: characters with a meaning in paths or shells become `_`.
std::string file_name(std::string name) {
  constexpr std::size_t longest = 200;
  for (char& letter : name) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                       (letter >= '0' && letter <= '9') || letter == '-' || letter == '_' || letter == '.' ||
                       letter == '=';
    if (!plain) letter = '_';
  }
  name.erase(0, name.find_first_not_of('.'));
  if (name.size() > longest) name.resize(longest);
  return name.empty() ? "_" : name;
}

}  // namespace

std::vector<std::string> file_names(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  std::set<std::string> taken;
  std::map<std::string, int> numbers;
  for (const std::string& name : names) {
    const std::string wanted = file_name(name);
    std::string file = wanted;
    for (int& number = numbers.try_emplace(wanted, 2).first->second; !taken.insert(file).second; ++number)
      file = fmt::format("{}~{}", wanted, number);
    files.push_back(file);
  }
  return files;
}

std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

}  // namespace labmouse
