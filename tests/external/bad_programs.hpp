// External mice for tests: programs of ours that misbehave, and how many of them run.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "labmouse/external/process.hpp"

namespace labmouse::test {

/// A word that no process of anybody else has.
inline std::string tag() { return "guest-of-" + std::to_string(getpid()); }

inline Launch bad_program(const std::string& how) {
  using namespace std::chrono_literals;
  Launch launch;
  launch.words = {LABMOUSE_BAD_PROGRAM, how, tag()};
  // Longer than a busy machine needs, shorter than a test may take.
  launch.limits.start = launch.limits.decision = 400ms;
  launch.limits.silence = 800ms;
  launch.limits.contest = 20s;
  return launch;
}

/// Processes with the tag among their words, and with that word in the first place where one is given.
inline int tagged_processes(const std::string& first = "") {
  int count = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    // One that ends meanwhile cannot be read any more: a stream says so in its state, an iterator throws.
    std::ostringstream words;
    words << std::ifstream(entry.path() / "cmdline", std::ios::binary).rdbuf();
    if (words.str().starts_with(first) && words.str().find(tag()) != std::string::npos) ++count;
  }
  return count;
}

/// Bad external mice that were started: the processes that start them still have other words.
inline int bad_programs() { return tagged_processes(LABMOUSE_BAD_PROGRAM); }

/// Children of this process, zombies among them.
inline int children() {
  int count = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream file(task.path() / "children");
    count += static_cast<int>(std::distance(std::istream_iterator<int>(file), std::istream_iterator<int>()));
  }
  return count;
}

inline int open_descriptors() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<int>(std::distance(begin(all), end(all)));
}

}  // namespace labmouse::test
