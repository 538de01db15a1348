// Robots of the capstone project: Python classes, run through a bridge script.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/external/launch.hpp"

namespace labmouse {

/// The bridge: a script for Python 2.7 and 3 that loads a robot's file and runs it by the labmouse protocol.
std::string_view capstone_bridge();

/// How to start the robot of a file: with the bridge, in the file's folder. The arguments follow the file's name in the
/// robot's sys.argv.
Launch capstone_launch(const std::string& robot, const std::string& python,
                       const std::vector<std::string>& arguments = {});

/// The default Python of a robot: the one that the user's shell starts.
inline constexpr const char* usual_python = "python3";

/// The version of a Python, such as "3.11.2"; empty if it does not run. Starts each Python once, unless its file
/// changes; in a sandbox if asked for, because it may be as untrusted as the robot.
std::string python_version(const std::string& python, bool sandbox);

/// The version of labmouse for Python; empty if this Python does not have it and all of these other modules. Runs
/// without a sandbox.
std::string labmouse_version_in(const std::string& python, const std::vector<std::string>& modules);

/// A fingerprint of the packages installed for a Python, with their versions; empty if it does not run. Starts it each
/// time; `environment` as in Launch.
std::string python_packages(const std::string& python, const std::vector<std::string>& environment, bool sandbox);

}  // namespace labmouse
