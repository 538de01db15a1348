#include "labmouse/external/our_installation.hpp"

#include <glob.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <utility>

#include "labmouse/functions/parse_number.hpp"

namespace labmouse {
namespace {

/// Adds the places below a folder where labmouse may be installed.
void add_installation(const std::string& prefix, std::vector<std::string>& hidden) {
  constexpr std::array<std::string_view, 8> places = {"/bin/labmouse*",
                                                      "/lib*/liblabmouse*",
                                                      "/lib*/*/liblabmouse*",
                                                      "/share/labmouse*",
                                                      "/lib*/python*/*-packages/labmouse*",
                                                      "/*-packages/labmouse*",
                                                      "/versions/*/lib/python*/*-packages/labmouse*",
                                                      "/labmouse/_native*"};
  for (const std::string_view place : places)
    for (std::string& path : matches_of(prefix + std::string(place))) hidden.push_back(std::move(path));
}

}  // namespace

std::string file_of_this_code() {
  const auto here = reinterpret_cast<std::uintptr_t>(&file_of_this_code);
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    std::string_view text = line;
    const auto begin = take_whole<std::uintptr_t>(text, 16);
    text.remove_prefix(text.starts_with('-') ? 1 : 0);
    const auto end = take_whole<std::uintptr_t>(text, 16);
    const auto path = line.find('/');
    if (begin && end && here >= *begin && here < *end && path != std::string::npos) return line.substr(path);
  }
  return "";
}

std::vector<std::string> matches_of(const std::string& pattern) {
  glob_t found{};
  std::vector<std::string> paths;
  if (glob(pattern.c_str(), GLOB_NOSORT, nullptr, &found) == 0)
    paths.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  return paths;
}

std::vector<std::string> our_installation(const std::set<std::string>& folders, const std::string& folder) {
  std::vector<std::string> ours = {file_of_this_code()};
  for (const std::string& each : folders) add_installation(each, ours);
  for (const char* prefix : {"/usr/local", "/opt/*"}) add_installation(prefix, ours);
  for (std::string& path : matches_of("/opt/labmouse*")) ours.push_back(std::move(path));
  if (!folder.empty()) add_installation(folder, ours);
  std::sort(ours.begin(), ours.end());
  ours.erase(std::unique(ours.begin(), ours.end()), ours.end());
  return ours;
}

}  // namespace labmouse
