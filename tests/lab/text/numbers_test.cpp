#include "labmouse/lab/text/numbers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_lines.hpp"
#include "labmouse/lab/text/json_problem.hpp"
#include "labmouse/lab/text/toml_text.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::ProblemAt;
using test::Says;

TEST(Numbers, ThatADoubleCannotHoldAreNone) {
  for (const char* large : {"1e309", "-1e309", "1.7976931348623159e308", "1e99999999999"}) {
    EXPECT_EQ(parse_number(large), std::nullopt) << large;
    EXPECT_THAT(why_no_number(large), testing::HasSubstr("large"));
  }
  for (const char* small : {"1e-320", "-1e-320", "1e-400", "2.2250738585072011e-308", "1e-99999999999"}) {
    EXPECT_EQ(parse_number(small), std::nullopt) << small;
    EXPECT_THAT(why_no_number(small), testing::HasSubstr("small"));
  }
  EXPECT_EQ(parse_number("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(parse_number("2.2250738585072014e-308"), std::numeric_limits<double>::min());
  EXPECT_EQ(why_no_number("1"), "");
}

TEST(Numbers, AreTheSameWhateverTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "cs_CZ.UTF-8", "C"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  EXPECT_EQ(parse_number("0.25"), 0.25);
  EXPECT_EQ(parse_number("0,25"), std::nullopt);
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

TEST(NumbersInJson, AreMissingFromAnEmptyText) {
  for (const char* empty : {"", " \r\n\t"}) EXPECT_THAT(json_problem(empty), ProblemAt(1, 1, "JSON", "empty"));
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

}  // namespace
}  // namespace labmouse
