#include "labmouse/functions/parse_number.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <random>
#include <string>
#include <string_view>

namespace labmouse {
namespace {

TEST(Numbers, AreDecimal) {
  EXPECT_EQ(parse_number("12"), 12.0);
  EXPECT_EQ(parse_number("-0.25"), -0.25);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("2."), 2.0);
  EXPECT_EQ(parse_number("007"), 7.0);
  EXPECT_EQ(parse_number("2.5e-3"), 0.0025);
  EXPECT_EQ(parse_number("1E+2"), 100.0);
  EXPECT_EQ(parse_number("0e999999999999"), 0.0);
  EXPECT_FALSE(std::signbit(*parse_number("-0")));
  for (const char* none : {"",         "-",  ".",  "e5", "1e",  "1e+",   "1e5x",  "0x1", "inf", "nan", "-inf",
                           "infinity", "+1", " 1", "1 ", "1,5", "1_000", "1.2.3", "--1", "one", "1\n"})
    EXPECT_EQ(parse_number(none), std::nullopt) << none;
}

TEST(Numbers, HaveAsManyDigitsAsTheyNeed) {
  EXPECT_EQ(parse_number("22.033333333333335"), 22.033333333333335);
  EXPECT_EQ(parse_number(std::string(400, '0') + "1" + std::string(20, '0')), 1e20);
  EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1e400"), 0.1);
}

TEST(Numbers, AreTheNearestDoubles) {
  std::mt19937_64 bits(1);
  for (int i = 0; i < 3000; ++i) {
    const std::uint64_t pattern = bits();
    double number = 0.0;
    std::memcpy(&number, &pattern, sizeof number);
    if (!std::isnormal(number)) continue;
    char text[1100];
    const auto shortest = std::to_chars(std::begin(text), std::end(text), number);
    EXPECT_EQ(parse_number({text, shortest.ptr}), number);
    // Halfway to the next one, to the last digit, and a little more: the even one, and the upper one.
    const auto middle = (static_cast<long double>(number) + std::nextafter(number, 2.0 * number)) / 2.0L;
    const auto whole = std::to_chars(std::begin(text), std::end(text), middle, std::chars_format::scientific, 800);
    double nearest = 0.0;
    std::from_chars(text, whole.ptr, nearest);
    if (!std::isnormal(nearest)) continue;
    EXPECT_EQ(parse_number({text, whole.ptr}), nearest);
  }
}

TEST(WholeNumbers, AreDigitsAloneAndFitTheirType) {
  EXPECT_EQ(parse_whole<int>("-12"), -12);
  EXPECT_EQ(parse_whole<std::uint64_t>("18446744073709551615"), 18446744073709551615U);
  for (const char* none : {"", "x", "1x", " 1", "+1", "-1", "0x1", "1.0", "18446744073709551616"})
    EXPECT_EQ(parse_whole<std::uint64_t>(none), std::nullopt) << none;
}

TEST(WholeNumbers, AreTakenOffTheFrontOfAText) {
  std::string_view text = "-12x1f 300";
  EXPECT_EQ(take_whole<int>(text), -12);
  EXPECT_EQ(text, "x1f 300");
  EXPECT_EQ(take_whole<int>(text), std::nullopt);
  text.remove_prefix(1);
  EXPECT_EQ(take_whole<unsigned>(text, 16), 0x1fU);
  text.remove_prefix(1);
  std::uint8_t number = 7;
  EXPECT_EQ(take_whole(text, number), NumberProblem::too_large);
  EXPECT_EQ(number, 7);
  EXPECT_EQ(text, "300");
}

}  // namespace
}  // namespace labmouse
