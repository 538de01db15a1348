#include "labmouse/lab/text/number_rows.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "labmouse/chance/rng.hpp"

namespace labmouse {
namespace {

using Numbers = std::vector<std::int32_t>;

Numbers read(std::string_view text, std::size_t columns, std::size_t most = 1000) {
  Numbers numbers;
  EXPECT_TRUE(read_rows(text, columns, most, numbers)) << text;
  return numbers;
}
bool refuses(std::string_view text, std::size_t columns, std::size_t most = 1000) {
  Numbers numbers;
  return !read_rows(text, columns, most, numbers);
}

TEST(NumberRows, AreAsInSourceMaps) {
  EXPECT_EQ(rows_text(Numbers{0, 1, -1, 16, -16, 700}, 6), "ACDgBhB4rB");
  EXPECT_EQ(rows_text(Numbers{5, 5, 6, 4}, 2), "KKCD");
}

TEST(NumberRows, SayHowOftenOneIsRepeated) {
  EXPECT_EQ(rows_text(Numbers{0, 0, 0, 0, 0, 0, 1, 0}, 2), "AA~ECA");
  EXPECT_EQ(read("AA~ECA", 2), (Numbers{0, 0, 0, 0, 0, 0, 1, 0}));
}

TEST(NumberRows, ComeBackWhateverTheyAre) {
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    const auto columns = 1 + static_cast<std::size_t>(rng.bits() % 8);
    Numbers numbers;
    for (std::size_t row = rng.bits() % 20; row > 0; --row)
      for (std::size_t column = 0; column < columns; ++column)
        numbers.push_back(static_cast<std::int32_t>(rng.bits()) >> rng.bits() % 32);
    EXPECT_EQ(read(rows_text(numbers, columns), columns), numbers);
  }
  constexpr auto least = std::numeric_limits<std::int32_t>::min(), most = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(read(rows_text(Numbers{most, least, most, most}, 1), 1), (Numbers{most, least, most, most}));
}

TEST(NumberRows, RefuseWhatIsNoText) {
  for (const char* text : {"A", "AAA", "A-", "g", "AAg", "~B", "AA~", "AA~A", "AA~D", "gggggggggA", "AA ", "ggggggggB"})
    EXPECT_TRUE(refuses(text, 2)) << text;
}

TEST(NumberRows, BecomeNoMoreThanTheyMay) {
  EXPECT_EQ(read("AA~G", 2, 8).size(), 8U);
  EXPECT_TRUE(refuses("AA~I", 2, 8));
  EXPECT_TRUE(refuses("AA~+/////D", 2, 1000));
}

}  // namespace
}  // namespace labmouse
