#include "labmouse/external/line_buffer.hpp"

#include <gtest/gtest.h>

namespace labmouse {
namespace {

TEST(LineBuffer, CutsLinesWhereverThePortionsEnd) {
  const std::string text = "one\ntwo\n\nfour\r\nfi\rve\n";
  for (std::size_t portion = 1; portion <= text.size(); ++portion) {
    LineBuffer buffer(100);
    std::string lines;
    for (std::size_t i = 0; i < text.size(); i += portion) {
      buffer.append(std::string_view(text).substr(i, portion));
      while (const auto line = buffer.next()) lines += std::string(*line) + "|";
    }
    EXPECT_EQ(lines, "one|two||four|five|") << portion;
    EXPECT_EQ(buffer.rest(), "");
  }
}

TEST(LineBuffer, KeepsAnUnfinishedLine) {
  LineBuffer buffer(100);
  buffer.append("one\ntw");
  EXPECT_EQ(buffer.next(), "one");
  EXPECT_EQ(buffer.next(), std::nullopt);
  EXPECT_EQ(buffer.rest(), "tw");
  buffer.append("o\n");
  EXPECT_EQ(buffer.rest(), "two\n");
  EXPECT_EQ(buffer.next(), "two");
}

TEST(LineBuffer, TakesLinesOfTheLongestLength) {
  LineBuffer buffer(3);
  buffer.append("abc\nabcd\nab\n");
  EXPECT_EQ(buffer.next(), "abc");
  EXPECT_FALSE(buffer.too_long());
  EXPECT_EQ(buffer.next(), std::nullopt);
  EXPECT_TRUE(buffer.too_long());
  EXPECT_EQ(buffer.next(), std::nullopt) << "it stays so";
  EXPECT_EQ(buffer.rest(), "abcd\nab\n");
}

TEST(LineBuffer, SeesThatAnUnfinishedLineIsTooLong) {
  LineBuffer buffer(3);
  buffer.append("abc");
  EXPECT_EQ(buffer.next(), std::nullopt);
  EXPECT_FALSE(buffer.too_long());
  buffer.append("d");
  EXPECT_EQ(buffer.next(), std::nullopt);
  EXPECT_TRUE(buffer.too_long());
}

}  // namespace
}  // namespace labmouse
