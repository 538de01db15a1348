// Robots as parameters of tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "labmouse/lab/robots/robot_files.hpp"

namespace labmouse::test {

/// Names a test after its robot.
class PrintRobot {
 public:
  template <class Named>
  std::string operator()(const testing::TestParamInfo<Named>& info) const {
    return info.param.name;
  }
};

inline Robot builtin(const char* name) { return find_robot(name).robot; }

}  // namespace labmouse::test
