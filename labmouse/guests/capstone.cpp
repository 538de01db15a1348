#include "labmouse/guests/capstone.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>

#include "labmouse/guests/patience.hpp"
#include "labmouse/guests/process.hpp"

namespace labmouse {
namespace {

/// The first line that a Python prints for a script; empty where it does not run.
std::string first_line(const std::string& python, const std::string& script, bool sandbox) {
  Launch launch;
  launch.sandbox = sandbox;
  // There it has no folder.
  if (sandbox) launch.directory = "/";
  launch.words = {python, "-c", script};
  GuestProcess process(launch);
  constexpr std::chrono::seconds longest(2);
  Patience patience(longest, longest);
  ContestClock clock(longest);
  while (patience.wait(process, clock) == GuestEvent::output) {
  }
  return std::string(process.lines().next().value_or(""));
}

}  // namespace

Launch capstone_launch(const std::string& robot, const std::string& python, const std::vector<std::string>& arguments) {
  const std::filesystem::path path(robot);
  Launch launch;
  launch.words = {python, "-u", "-c", std::string(capstone_bridge()), path.filename().string()};
  launch.words.insert(launch.words.end(), arguments.begin(), arguments.end());
  launch.directory = path.parent_path().string();
  launch.owns_directory = true;
  launch.beginning = "the Robot of " + path.filename().string() + " was made";
  return launch;
}

std::string python_version(const std::string& python, bool sandbox) {
  static std::mutex mutex;
  static std::map<std::string, std::string> known;
  const std::lock_guard lock(mutex);
  const auto [place, is_new] = known.try_emplace(python);
  if (is_new) place->second = first_line(python, "import sys; print('%d.%d.%d' % sys.version_info[:3])", sandbox);
  return place->second;
}

}  // namespace labmouse
