#include "labmouse/external/capstone.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <system_error>
#include <utility>

#include "labmouse/external/command_line.hpp"
#include "labmouse/external/patience.hpp"
#include "labmouse/external/process.hpp"

namespace labmouse {
namespace {

/// The first line of output of a Python script; empty if the Python does not run.
std::string first_line(const std::string& python, const std::string& script, bool sandbox,
                       const std::vector<std::string>& environment = {}) {
  Launch launch;
  launch.environment = environment;
  launch.sandbox = sandbox;
  // It needs no folder.
  if (sandbox) launch.directory = "/";
  launch.words = {python, "-c", script};
  ExternalProcess process(launch);
  constexpr std::chrono::seconds longest(2);
  Patience patience(longest, longest);
  ContestClock clock(longest);
  while (patience.wait(process, clock) == ExternalEvent::output) {
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
  static std::map<std::pair<std::string, std::filesystem::file_time_type>, std::string> known;
  const std::lock_guard lock(mutex);
  std::error_code error;
  const auto changed = std::filesystem::last_write_time(program_path(python, ""), error);
  const auto [place, is_new] = known.try_emplace({python, error ? std::filesystem::file_time_type() : changed});
  if (is_new) place->second = first_line(python, "import sys; print('%d.%d.%d' % sys.version_info[:3])", sandbox);
  return place->second;
}

std::string labmouse_version_in(const std::string& python, const std::vector<std::string>& modules) {
  std::string script = "import importlib.util, labmouse\n";
  for (const std::string& module : modules) script += "assert importlib.util.find_spec('" + module + "')\n";
  return first_line(python, script + "print(labmouse.__version__)", false);
}

std::string python_packages(const std::string& python, const std::vector<std::string>& environment, bool sandbox) {
  // The script must also run in Python 2.7.
  constexpr const char* script =
      "import hashlib, os, sys; ends = ('.dist-info', '.egg-info', '.egg', '.pth', '.egg-link'); "
      "names = sorted(n for p in sys.path if os.path.isdir(p) for n in os.listdir(p) if n.endswith(ends)); "
      "print('%d %s' % (len(names), hashlib.sha1(' '.join(names).encode('utf-8')).hexdigest()))";
  return first_line(python, script, sandbox, environment);
}

}  // namespace labmouse
