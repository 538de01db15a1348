#include "labmouse/lab/mice/mouse_list.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::HasSubstr;

TEST(MouseList, HasEveryMouseAndEveryParameter) {
  const std::string list = mouse_list();
  for (const BuiltinMouse* mouse : all_mice()) {
    EXPECT_THAT(list, HasSubstr(std::string(mouse->name) + "  "));
    for (const Parameter& parameter : mouse->parameters)
      EXPECT_THAT(list, HasSubstr("    " + std::string(parameter.name) + "=" + std::string(parameter.default_value)));
  }
}

/// The words of a text with one blank between two, however its lines are broken.
std::string joined(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

TEST(MouseSheet, SaysHowAMouseWorksAndWhoseIdeaItIs) {
  for (const BuiltinMouse* mouse : all_mice()) {
    const NamedText sheet = mouse_sheet(std::string(mouse->name));
    EXPECT_EQ(sheet.error, "");
    // Both are whole sentences.
    EXPECT_GT(mouse->method.size(), 100U) << mouse->name;
    EXPECT_EQ(mouse->method.back(), '.') << mouse->name;
    EXPECT_EQ(mouse->source.back(), '.') << mouse->name;
    EXPECT_THAT(sheet.text, HasSubstr(std::string(mouse->method.substr(0, 20))));
    EXPECT_THAT(sheet.text, HasSubstr(std::string(mouse->source.substr(0, 8))));
    for (const Parameter& parameter : mouse->parameters)
      EXPECT_THAT(joined(sheet.text), HasSubstr(std::string(parameter.meaning))) << parameter.name;
    for (std::size_t at = 0, end = 0; at < sheet.text.size(); at = end + 1) {
      end = sheet.text.find('\n', at);
      EXPECT_LE(end - at, 120U) << sheet.text.substr(at, end - at);
    }
  }
}

TEST(MouseSheet, ExplainsEachParameterInASentence) {
  for (const BuiltinMouse* mouse : all_mice())
    for (const Parameter& parameter : mouse->parameters) {
      const std::string meaning(parameter.meaning), name = fmt::format("{}:{}", mouse->name, parameter.name);
      EXPECT_TRUE(meaning.front() >= 'A' && meaning.front() <= 'Z') << name;
      EXPECT_EQ(meaning.back(), '.') << name;
      EXPECT_GE(std::count(meaning.begin(), meaning.end(), ' '), 3) << name;
      EXPECT_THAT(meaning, ::testing::Not(HasSubstr("the same as"))) << name;
    }
}

TEST(MouseSheet, SaysTheUnitOfEachNumberOfAriadne) {
  for (const Parameter& parameter : find_mouse("ariadne")->parameters)
    if (parameter.type == ParameterType::real) {
      EXPECT_THAT(std::string(parameter.meaning),
                  ::testing::ContainsRegex("1/30 step|search times of one cell|in ms|: ms for|s of search|no unit"))
          << parameter.name;
    }
}

TEST(MouseSheet, HasAHeadingOverParametersThatCountInSecondsAlone) {
  const std::string sheet = mouse_sheet("ariadne").text;
  const auto steps = sheet.find("only in steps\n"), seconds = sheet.find("only in seconds\n");
  ASSERT_NE(steps, std::string::npos);
  ASSERT_NE(seconds, std::string::npos);
  EXPECT_LT(sheet.find("prior="), steps);
  for (const Parameter& parameter : find_mouse("ariadne")->parameters) {
    const auto at = sheet.find(fmt::format("\n    {}=", parameter.name));
    EXPECT_EQ(at > seconds, parameter.scope == ParameterScope::seconds) << parameter.name;
  }
  EXPECT_THAT(mouse_sheet("two-way").text, ::testing::Not(HasSubstr("only in")));
}

TEST(MouseSheet, SuggestsAMouse) { EXPECT_THAT(mouse_sheet("flod").error, Says("'flod'", "'flood'")); }

}  // namespace
}  // namespace labmouse
