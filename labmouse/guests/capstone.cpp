#include "labmouse/guests/capstone.hpp"

#include <charconv>
#include <filesystem>
#include <optional>

#include "labmouse/guests/command_line.hpp"

namespace labmouse {
namespace {

/// The first line that a Python prints for a script; empty where it does not run.
std::string first_line(const std::string& python, const std::string& script) {
  Launch launch;
  launch.words = {python, "-c", script};
  GuestProcess process(launch);
  const auto deadline = GuestProcess::Clock::now() + launch.limits.start;
  while (process.wait(deadline) == GuestEvent::output) {
  }
  return std::string(process.lines().next().value_or(""));
}

/// The second number of a Python 3's version; nothing where it does not run or is another Python.
std::optional<int> minor_version(const std::string& python) {
  const std::string line =
      first_line(python, "import sys; print(sys.version_info[1] if sys.version_info[0] == 3 else 'old')");
  int minor = 0;
  if (std::from_chars(line.data(), line.data() + line.size(), minor).ec != std::errc()) return std::nullopt;
  return minor;
}

std::string find_newest_python3() {
  constexpr int latest = 40;  // versions that may be written yet
  const std::optional<int> plain = minor_version("python3");
  for (int minor = latest; minor > plain.value_or(0); --minor) {
    std::string name = "python3." + std::to_string(minor);
    if (!program_path(name, "").empty() && minor_version(name) == minor) return name;
  }
  return plain ? "python3" : "";
}

}  // namespace

Launch capstone_launch(const std::string& robot, const std::string& python) {
  const std::filesystem::path path(robot);
  Launch launch;
  launch.words = {python, "-u", "-c", std::string(capstone_bridge()), path.filename().string()};
  launch.directory = path.parent_path().string();
  return launch;
}

bool python_runs(const std::string& python) { return first_line(python, "print('runs')") == "runs"; }

const std::string& newest_python3() {
  static const std::string newest = find_newest_python3();
  return newest;
}

}  // namespace labmouse
