// Robots of the capstone project: Python classes, played by a bridge of ours.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/guests/process.hpp"

namespace labmouse {

/// The bridge: a Python script for Python 2.7 and 3 that loads a robot's file and plays it by our protocol.
std::string_view capstone_bridge();

/// How to start the robot of a file: the bridge, in the file's folder.
Launch capstone_launch(const std::string& robot, const std::string& python);

/// The Python of a robot for which none is named: the one that the user's shell starts, with what is installed for it.
inline constexpr const char* usual_python = "python3";

/// Whether that Python runs at all; starts it.
bool python_runs(const std::string& python);

}  // namespace labmouse
