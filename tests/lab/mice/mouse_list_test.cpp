#include "labmouse/lab/mice/mouse_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/strategies/roster.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::HasSubstr;

TEST(MouseList, HasEveryMouseAndEveryParameter) {
  const std::string list = mouse_list();
  for (const RosterEntry* mouse : all_mice()) {
    EXPECT_THAT(list, HasSubstr(std::string(mouse->name) + "  "));
    for (const Parameter& parameter : mouse->parameters)
      EXPECT_THAT(list, HasSubstr("    " + std::string(parameter.name) + "=" + std::string(parameter.default_value)));
  }
}

TEST(MouseSheet, SaysHowAMouseWorksAndWhoseIdeaItIs) {
  for (const RosterEntry* mouse : all_mice()) {
    const NamedText sheet = mouse_sheet(std::string(mouse->name));
    EXPECT_EQ(sheet.error, "");
    // Both are whole sentences.
    EXPECT_GT(mouse->method.size(), 100U) << mouse->name;
    EXPECT_EQ(mouse->method.back(), '.') << mouse->name;
    EXPECT_EQ(mouse->source.back(), '.') << mouse->name;
    EXPECT_THAT(sheet.text, HasSubstr(std::string(mouse->method.substr(0, 20))));
    EXPECT_THAT(sheet.text, HasSubstr(std::string(mouse->source.substr(0, 8))));
    for (const Parameter& parameter : mouse->parameters)
      EXPECT_THAT(sheet.text, HasSubstr(std::string(parameter.meaning)));
    for (std::size_t at = 0, end = 0; mouse->parameters.empty() && at < sheet.text.size(); at = end + 1) {
      end = sheet.text.find('\n', at);
      EXPECT_LE(end - at, 120U) << sheet.text.substr(at, end - at);
    }
  }
}

TEST(MouseSheet, SaysWhichParametersCountInSecondsAlone) {
  const std::string sheet = mouse_sheet("ariadne").text;
  EXPECT_THAT(sheet, ::testing::ContainsRegex("cell_most=[^\n]*in seconds"));
  EXPECT_THAT(sheet, ::testing::Not(::testing::ContainsRegex("travel=[^\n]*in seconds")));
}

TEST(MouseSheet, SuggestsAMouse) { EXPECT_THAT(mouse_sheet("flod").error, Says("'flod'", "'flood'")); }

}  // namespace
}  // namespace labmouse
