#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "labmouse/lab/store/figures.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

/// Equal to the last bit, also where a number is none.
bool same(const Value& a, const Value& b) {
  if (a.index() != b.index()) return false;
  const auto *one = std::get_if<double>(&a), *other = std::get_if<double>(&b);
  if (one == nullptr) return a == b;
  return (std::isnan(*one) && std::isnan(*other)) || (*one == *other && std::signbit(*one) == std::signbit(*other));
}

void comes_back(const std::vector<Value>& figures) {
  const auto read = read_figures(figures_text(figures));
  ASSERT_TRUE(read) << figures_text(figures);
  ASSERT_EQ(read->size(), figures.size());
  for (std::size_t i = 0; i < figures.size(); ++i) EXPECT_TRUE(same((*read)[i], figures[i])) << figures_text(figures);
}

TEST(StoreFigures, ComeBackExactly) {
  using Limits = std::numeric_limits<double>;
  comes_back({});
  comes_back({Value(), nullptr, true, false, std::int64_t{0}, 0.0, -0.0, 3.0, std::int64_t{3}, std::string("3")});
  comes_back({0.1, 1e300, Limits::min(), Limits::max(), Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(),
              1e16, 123456789012345678.0});
  comes_back({std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()});
  comes_back({std::string(), std::string("\0\x01\n\"\\", 5), std::string("M\xc3\xa4use"), std::string("\xff\xfe")});
  comes_back({JsonText{"null"}, JsonText{"{\"b\": 1,  \"a\":[2 ]}"}, JsonText{"[]"}, JsonText{"\"\""}});
}

RC_GTEST_PROP(StoreFigures, OfAnyKindComeBack, ()) {
  const auto figure = rc::gen::oneOf(
      // Numbers that are nearly 0 are refused wherever they are read.
      rc::gen::map(rc::gen::arbitrary<double>(),
                   [](double value) { return Value(std::fpclassify(value) == FP_SUBNORMAL ? 0.0 : value); }),
      rc::gen::map(rc::gen::arbitrary<std::int64_t>(), [](std::int64_t value) { return Value(value); }),
      rc::gen::map(rc::gen::arbitrary<bool>(), [](bool value) { return Value(value); }),
      rc::gen::map(rc::gen::arbitrary<std::string>(), [](const std::string& value) { return Value(value); }),
      rc::gen::map(rc::gen::arbitrary<std::vector<std::int64_t>>(),
                   [](const std::vector<std::int64_t>& value) { return Value(JsonText{Json(value).dump(1)}); }),
      rc::gen::just(Value()), rc::gen::just(Value(nullptr)));
  const auto figures = *rc::gen::container<std::vector<Value>>(figure);
  const auto read = read_figures(figures_text(figures));
  RC_ASSERT(read && read->size() == figures.size());
  for (std::size_t i = 0; i < figures.size(); ++i) RC_ASSERT(same((*read)[i], figures[i]));
}

TEST(StoreFigures, AreNothingElse) {
  for (const char* text : {"", "{}", "null", "[", "[[1]]", "[{}]", "[{\"json\":\"{\"}]", "[{\"json\":1}]",
                           "[{\"real\":\"one\"}]", "[{\"bytes\":\"0\"}]", "[{\"bytes\":\"0g\"}]", "[{\"a\":1}]"})
    EXPECT_FALSE(read_figures(text)) << text;
}

}  // namespace
}  // namespace labmouse
