// Mice as names of tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse::test {

/// The mouse's name with what no test's name may hold replaced.
inline std::string mouse_name(const testing::TestParamInfo<const BuiltinMouse*>& mouse) {
  std::string name(mouse.param->name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace labmouse::test
