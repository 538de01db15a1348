// Robots of the capstone project: Python classes, played by a bridge of ours.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/external/launch.hpp"

namespace labmouse {

/// The bridge: a Python script for Python 2.7 and 3 that loads a robot's file and plays it by our protocol.
std::string_view capstone_bridge();

/// How to start the robot of a file: the bridge, in the file's folder. The arguments stand behind the file's name in
/// the robot's sys.argv.
Launch capstone_launch(const std::string& robot, const std::string& python,
                       const std::vector<std::string>& arguments = {});

/// The Python of a robot for which none is named: the one that the user's shell starts, with what is installed for it.
inline constexpr const char* usual_python = "python3";

/// The version of a Python: "3.11.2"; empty where it does not run. Starts it, once a program that does not change,
/// where it is asked for in a sandbox: it may be as strange as the robot.
std::string python_version(const std::string& python, bool sandbox);

/// A text that is another one where other packages are installed for a Python, or other versions of them; empty where
/// it does not run. Starts it each time; `environment` as of Launch.
std::string python_packages(const std::string& python, const std::vector<std::string>& environment, bool sandbox);

}  // namespace labmouse
