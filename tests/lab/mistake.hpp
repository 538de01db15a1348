// A file with a mistake, for readers that say where it is.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "labmouse/maze/formats/format.hpp"
#include "tests/says.hpp"

namespace labmouse::test {

struct Mistake {
  std::string text;
  int line, column;
  std::vector<std::string> says;  ///< parts of the reason
};

inline void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.text; }

/// The first of the problems is that mistake.
inline void expect_first(const std::vector<Problem>& problems, const Mistake& mistake) {
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems.front().line, mistake.line);
  EXPECT_EQ(problems.front().column, mistake.column);
  EXPECT_THAT(problems.front().reason, HasParts(mistake.says));
}

}  // namespace labmouse::test
