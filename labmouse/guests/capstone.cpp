#include "labmouse/guests/capstone.hpp"

#include <charconv>
#include <filesystem>
#include <optional>

#include "labmouse/guests/command_line.hpp"

namespace labmouse {
namespace {

/// The second number of a Python 3's version; nothing where it does not run or is another Python.
std::optional<int> minor_version(const std::string& python) {
  Launch launch;
  launch.words = {python, "-c", "import sys; print(sys.version_info[1] if sys.version_info[0] == 3 else 'old')"};
  GuestProcess process(launch);
  const auto deadline = GuestProcess::Clock::now() + launch.limits.start;
  while (process.wait(deadline) == GuestEvent::output) {
  }
  const auto line = process.lines().next();
  int minor = 0;
  if (!line || std::from_chars(line->data(), line->data() + line->size(), minor).ec != std::errc()) return std::nullopt;
  return minor;
}

std::string find_newest_python3() {
  constexpr int latest = 40;  // versions that may be written yet
  const std::optional<int> plain = minor_version("python3");
  for (int minor = latest; minor > plain.value_or(0); --minor) {
    const std::string name = "python3." + std::to_string(minor);
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

const std::string& newest_python3() {
  static const std::string newest = find_newest_python3();
  return newest;
}

}  // namespace labmouse
