#include "labmouse/guests/capstone.hpp"

#include <filesystem>

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

}  // namespace

Launch capstone_launch(const std::string& robot, const std::string& python) {
  const std::filesystem::path path(robot);
  Launch launch;
  launch.words = {python, "-u", "-c", std::string(capstone_bridge()), path.filename().string()};
  launch.directory = path.parent_path().string();
  return launch;
}

bool python_runs(const std::string& python) { return first_line(python, "print('runs')") == "runs"; }

}  // namespace labmouse
