// The header for firmware and the reader of its lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "labmouse/lab/live/live_reader.hpp"
#include "tests/lab/live/stream_in_c.h"

namespace labmouse {
namespace {

std::string printed;

std::string lines_of(void (*stream)(void (*put)(char))) {
  printed.clear();
  stream([](char letter) { printed += letter; });
  return printed;
}

TEST(StreamHeader, PrintsTheSameInBothLanguages) {
  EXPECT_EQ(lines_of(stream_in_c), lines_of(stream_in_cpp11));
  EXPECT_EQ(lines_of(stream_in_c),
            "\nstart *40\n0 0 N 10? batt=7900 ir=12,-840,0 state=search_*_2 *38\n v=-2147483648 *63\n"
            "12 63 W 011 route=NNE *40\n");
}

TEST(StreamHeader, IsReadAsItWasMeant) {
  LiveReader reader;
  const std::vector<LiveLine> lines = reader.feed(lines_of(stream_in_c));
  EXPECT_EQ(reader.noise(), 0);
  ASSERT_EQ(lines.size(), 4U);
  for (const LiveLine& line : lines) EXPECT_TRUE(line.has_checksum);
  EXPECT_TRUE(lines[0].is_restart);
  EXPECT_EQ(lines[1].seen, (SeenCell{{{0, 0}, Heading::north}, {false, std::nullopt, std::nullopt, true}}));
  EXPECT_EQ(lines[1].fields, (std::vector<LiveField>{{"batt", "7900"}, {"ir", "12,-840,0"}, {"state", "search_*_2"}}));
  EXPECT_EQ(lines[2].fields, (std::vector<LiveField>{{"v", "-2147483648"}}));
  EXPECT_EQ(lines[3].seen, (SeenCell{{{12, 63}, Heading::west}, {true, std::nullopt, false, true}}));
}

TEST(StreamHeader, LosesEveryDamagedLine) {
  const std::string text = lines_of(stream_in_c);
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const unsigned bit : {1U, 2U, 4U, 8U, 16U, 32U, 64U, 128U}) {
      std::string damaged = text;
      damaged[i] = static_cast<char>(static_cast<unsigned char>(damaged[i]) ^ bit);
      const std::vector<LiveLine> good = LiveReader().feed(text);
      for (const LiveLine& line : LiveReader().feed(damaged)) {
        const bool is_one = std::any_of(good.begin(), good.end(), [&](const LiveLine& each) {
          return each.is_restart == line.is_restart && each.seen == line.seen && each.fields == line.fields;
        });
        EXPECT_TRUE(is_one) << damaged;
      }
    }
  }
}

}  // namespace
}  // namespace labmouse
