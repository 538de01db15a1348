// Whether this system has sandboxes to test.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "labmouse/external/sandbox.hpp"

namespace labmouse::test {

/// Whether tests of sandboxes can run. Where nothing may be skipped there have to be some.
inline bool has_sandboxes() {
  if (std::getenv("LABMOUSE_NO_SKIP") != nullptr) {
    EXPECT_EQ(why_no_sandbox(), "");
    return true;
  }
  return why_no_sandbox().empty();
}

}  // namespace labmouse::test
