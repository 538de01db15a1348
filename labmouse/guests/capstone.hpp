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

/// Whether that Python runs at all; starts it.
bool python_runs(const std::string& python);

/// The newest Python 3 that PATH has and that runs, `python3` among equals; empty where there is none. Starts some of
/// them, and remembers the answer.
const std::string& newest_python3();

}  // namespace labmouse
