#include "labmouse/lab/studies/parameter_range.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ParameterRange range(ParameterType type, double low, double high) {
  return {{"number", type, "1", -1000, 1'000'000, "", ""}, low, high};
}

std::string written(double value, double low = -1000, double high = 1'000'000) {
  return written_value(range(ParameterType::real, low, high), value);
}

TEST(WrittenValue, HasFourDigitsThatSaySomething) {
  EXPECT_EQ(written(0.123456), "0.1235");
  EXPECT_EQ(written(12.3456), "12.35");
  EXPECT_EQ(written(999.96), "1000");
  EXPECT_EQ(written(123456.7), "123457");
  EXPECT_EQ(written(0.00012344), "0.0001234");
  EXPECT_EQ(written(-3.14159), "-3.142");
  EXPECT_EQ(written(0.5), "0.5");
  EXPECT_EQ(written(0.0), "0");
  EXPECT_EQ(written(1e-12), "0");
}

TEST(WrittenValue, StaysInItsRange) {
  EXPECT_EQ(written(0.99996, 0, 0.99997), "0.99996");
  EXPECT_EQ(written(0.123446, 0.123446, 1), "0.12345");
  EXPECT_EQ(written(7.0, 0, 0.25), "0.25");
  EXPECT_EQ(written(-7.0, 2.5, 3), "2.5");
}

TEST(WrittenValue, OfAWholeNumberIsWhole) {
  EXPECT_EQ(written_value(range(ParameterType::whole, 1, 8), 2.6), "3");
  EXPECT_EQ(written_value(range(ParameterType::whole, 1, 8), 99.0), "8");
}

TEST(ParameterRange, SharesItsValuesEvenly) {
  const ParameterRange real = range(ParameterType::real, 2, 4), whole = range(ParameterType::whole, 1, 4);
  EXPECT_EQ(value_at(real, 0.0), "2");
  EXPECT_EQ(value_at(real, 0.25), "2.5");
  EXPECT_EQ(value_at(real, 1.0), "4");
  std::map<std::string, int> times;
  for (int i = 0; i <= 1000; ++i) ++times[value_at(whole, i / 1000.0)];
  EXPECT_EQ(times, (std::map<std::string, int>{{"1", 250}, {"2", 250}, {"3", 250}, {"4", 251}}));
}

TEST(ParameterRange, KnowsAtWhichShareAValueStands) {
  const ParameterRange real = range(ParameterType::real, 2, 4), whole = range(ParameterType::whole, 1, 4);
  EXPECT_DOUBLE_EQ(share_of(real, 3.5), 0.75);
  EXPECT_DOUBLE_EQ(share_of(real, 99), 1.0);
  EXPECT_DOUBLE_EQ(share_of(whole, 2), 0.375);
  for (int value = 1; value <= 4; ++value) EXPECT_EQ(value_at(whole, share_of(whole, value)), std::to_string(value));
}

std::string refusal(std::string_view spec, std::string_view text) {
  const RangesResult result = read_ranges(spec, text);
  EXPECT_THAT(result.ranges, IsEmpty());
  return result.error;
}

TEST(Ranges, AreTheDeclaredOnesOrNarrower) {
  const RangesResult result = read_ranges("visit-counter:coverage=0.3", "random_share,coverage=0.25:0.75");
  EXPECT_EQ(result.error, "");
  ASSERT_EQ(result.ranges.size(), 2U);
  EXPECT_EQ(result.ranges[0].parameter.name, "random_share");
  EXPECT_EQ(result.ranges[0].low, 0.0);
  EXPECT_EQ(result.ranges[0].high, 1.0);
  EXPECT_EQ(result.ranges[1].parameter.name, "coverage");
  EXPECT_EQ(result.ranges[1].low, 0.25);
  EXPECT_EQ(result.ranges[1].high, 0.75);
}

TEST(Ranges, AreOfNumbersAlone) {
  EXPECT_THAT(refusal("two-way", "join_legs"), Says("'join_legs'", "'two-way'", "yes/no", "numbers", ": bias"));
  EXPECT_THAT(refusal("visit-counter", "search"),
              Says("'search'", "'visit-counter'", "choice", "numbers", ": random_share, coverage"));
  EXPECT_THAT(refusal("phases", "weights=1:2"), Says("'weights'", "list", "numbers"));
  EXPECT_THAT(refusal("potential", "order"), Says("'order'", "'potential'", "numbers", "none"));
}

TEST(Ranges, AreRefusedWhereTheyAreNone) {
  EXPECT_THAT(refusal("flod", "stride"), Says("'flod'", "'flood'"));
  EXPECT_THAT(refusal("flood,certify", "stride"), Says("'flood,certify'", "2 mice"));
  EXPECT_THAT(refusal("oracle", "stride"), Says("oracle", "no parameters"));
  EXPECT_THAT(refusal("flood", "strid=1:2"), Says("'strid'", "'stride'"));
  EXPECT_THAT(refusal("certify", "stride"), Says("'certify'", "no parameters"));
  EXPECT_THAT(refusal("flood", "stride=1:9"), Says("'9'", "'stride'", "'flood'", "1 to 8"));
  EXPECT_THAT(refusal("flood", "stride=1.5:3"), Says("'1.5'", "'stride'", "whole number"));
  EXPECT_THAT(refusal("flood", "stride=3:3"), Says("'3:3'", "above"));
  EXPECT_THAT(refusal("flood", "stride,stride=1:2"), Says("'stride'", "twice"));
  for (const std::string bad : {"", "1", "1:", "1:2:3", "a:2", "0.0000001:2"})
    EXPECT_THAT(refusal("flood", "stride=" + bad), Says("'" + bad + "'", " LOW:HIGH"));
  for (const char* bad : {"", "=1:2", "stride,"}) EXPECT_THAT(refusal("flood", bad), HasSubstr("NAME=LOW:HIGH")) << bad;
}

}  // namespace
}  // namespace labmouse
