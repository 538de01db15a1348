#include "labmouse/lab/text/numbers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_lines.hpp"
#include "labmouse/lab/text/json_problem.hpp"
#include "labmouse/lab/text/toml_text.hpp"
#include "labmouse/strategies/parameter.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::ProblemAt;
using test::Says;

TEST(Numbers, AreDecimal) {
  EXPECT_EQ(number_in("12"), 12.0);
  EXPECT_EQ(number_in("-0.25"), -0.25);
  EXPECT_EQ(number_in(".5"), 0.5);
  EXPECT_EQ(number_in("2."), 2.0);
  EXPECT_EQ(number_in("007"), 7.0);
  EXPECT_EQ(number_in("2.5e-3"), 0.0025);
  EXPECT_EQ(number_in("1E+2"), 100.0);
  EXPECT_EQ(number_in("0e999999999999"), 0.0);
  EXPECT_FALSE(std::signbit(*number_in("-0")));
  for (const char* none : {"",         "-",  ".",  "e5", "1e",  "1e+",   "1e5x",  "0x1", "inf", "nan", "-inf",
                           "infinity", "+1", " 1", "1 ", "1,5", "1_000", "1.2.3", "--1", "one", "1\n"})
    EXPECT_EQ(number_in(none), std::nullopt) << none;
}

TEST(Numbers, HaveAsManyDigitsAsTheyNeed) {
  EXPECT_EQ(number_in("22.033333333333335"), 22.033333333333335);
  EXPECT_EQ(number_in(std::string(400, '0') + "1" + std::string(20, '0')), 1e20);
  EXPECT_EQ(number_in("0." + std::string(400, '0') + "1e400"), 0.1);
  double number = 0.0;
  EXPECT_TRUE(parse_number("22.033333333333335", number));
  EXPECT_EQ(number, 22.033333333333335);
}

TEST(Numbers, ThatADoubleCannotHoldAreNone) {
  for (const char* large : {"1e309", "-1e309", "1.7976931348623159e308", "1e99999999999"}) {
    EXPECT_EQ(number_in(large), std::nullopt) << large;
    EXPECT_THAT(why_no_number(large), testing::HasSubstr("large"));
  }
  for (const char* small : {"1e-320", "-1e-320", "1e-400", "2.2250738585072011e-308", "1e-99999999999"}) {
    EXPECT_EQ(number_in(small), std::nullopt) << small;
    EXPECT_THAT(why_no_number(small), testing::HasSubstr("small"));
  }
  EXPECT_EQ(number_in("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(number_in("2.2250738585072014e-308"), std::numeric_limits<double>::min());
  EXPECT_EQ(why_no_number("1"), "");
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
    EXPECT_EQ(number_in({text, shortest.ptr}), number);
    // Halfway to the next one, to the last digit, and a little more: the even one, and the upper one.
    const auto middle = (static_cast<long double>(number) + std::nextafter(number, 2.0 * number)) / 2.0L;
    const auto whole = std::to_chars(std::begin(text), std::end(text), middle, std::chars_format::scientific, 800);
    double nearest = 0.0;
    std::from_chars(text, whole.ptr, nearest);
    if (!std::isnormal(nearest)) continue;
    EXPECT_EQ(number_in({text, whole.ptr}), nearest);
  }
}

TEST(Numbers, AreTheSameWhateverTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "cs_CZ.UTF-8", "C"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  EXPECT_EQ(number_in("0.25"), 0.25);
  EXPECT_EQ(number_in("0,25"), std::nullopt);
  EXPECT_EQ(rounded(0.123456, 3), 0.123);
  EXPECT_EQ(decimal(265.2F), 265.2);
  EXPECT_EQ(read_json("[0.25]")[0], 0.25);
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Numbers, AreRoundedWhateverTheirSize) {
  EXPECT_EQ(rounded(123456.0, 3), 123000.0);
  EXPECT_EQ(rounded(1e-320, 5), 0.0);
  EXPECT_TRUE(std::isinf(rounded(std::numeric_limits<double>::infinity(), 5)));
  EXPECT_TRUE(std::isnan(rounded(std::numeric_limits<double>::quiet_NaN(), 5)));
}

TEST(NumbersInJson, ThatADoubleCannotHoldMakeItNone) {
  const std::vector<std::string> all = {"1e309", "-1E+309", "1e-320", "1e-400", "0." + std::string(400, '0') + "1"};
  for (const std::string& number : all) {
    const std::string text = "{\"a\": \"1e309\",\n \"b\": [0, " + number + "]}";
    EXPECT_TRUE(read_json(text).is_discarded()) << number;
    EXPECT_TRUE(read_ordered_json(text).is_discarded()) << number;
    EXPECT_THAT(json_problem(text), ProblemAt(2, 11, "JSON", number.size() > 40 ? "..." : number.c_str()));
  }
  for (const char* good : {"[1e308, 1e-300, 0e-400]", "[\"1e309\", 12345678901234567890123]", "[0.1]"})
    EXPECT_FALSE(read_json(good).is_discarded()) << good;
}

TEST(NumbersInJson, DoNotHideAMistakeBeforeThem) {
  EXPECT_THAT(json_problem("[1,, 1e309]"), ProblemAt(1, 4, "JSON"));
  EXPECT_THAT(json_problem("[1, 1e309,, 2]"), ProblemAt(1, 5, "JSON", "'1e309'"));
}

TEST(NumbersInJson, HaveTheirPlaceInJsonLines) {
  const LineReader any = {[](const ReadJson&) { return ""; }, [](const ReadJson&) { return ""; }, [] { return false; }};
  EXPECT_THAT(read_json_lines("{}\n{\"a\": 1e-320}\n", any), testing::ElementsAre(ProblemAt(2, 7, "'1e-320'")));
  EXPECT_THAT(read_json_lines("{}\n{\"a\" 1}\n", any), testing::ElementsAre(ProblemAt(2, 6, "JSON")));
}

TEST(NumbersInToml, ThatADoubleCannotHoldAreRefused) {
  for (const char* bad : {"1e-320", "-1e-400", "1e309"}) {
    const TomlText read = parse_toml(std::string("a = 1.0\n[b]\nc = [[2.0], [") + bad + "]]\n");
    ASSERT_EQ(read.problems.size(), 1U) << bad;
    EXPECT_EQ(read.problems.front().line, 3) << bad;
  }
  EXPECT_TRUE(parse_toml("a = [1.5, 0.0, -0.0, 3, 0e0, +0.0_0]\n").problems.empty());
  EXPECT_EQ(parse_toml("\"\xC2\xB2\" = [0.0, 1e-400]").problems.front().column, 13);
}

TEST(WholeNumbers, AreDigitsAloneAndFitTheirType) {
  EXPECT_EQ(whole_in<int>("-12"), -12);
  EXPECT_EQ(whole_in<std::uint64_t>("18446744073709551615"), 18446744073709551615U);
  for (const char* none : {"", "x", "1x", " 1", "+1", "-1", "0x1", "1.0", "18446744073709551616"})
    EXPECT_EQ(whole_in<std::uint64_t>(none), std::nullopt) << none;
}

}  // namespace
}  // namespace labmouse
