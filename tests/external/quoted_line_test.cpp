#include "labmouse/external/quoted_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/says.hpp"

namespace labmouse {
namespace {

using namespace std::string_literals;
using test::Says;
using testing::Not;

TEST(QuotedLine, LeavesPrintableLettersAsTheyAre) {
  EXPECT_EQ(quoted_line("move -90 3 ~!"), "'move -90 3 ~!'");
  EXPECT_EQ(quoted_line(""), "''");
}

TEST(QuotedLine, ShowsWhatDoesNotShow) {
  EXPECT_EQ(quoted_line("move\t0\0 1\n\\"s), "'move\\t0\\0 1\\n\\\\'");
  EXPECT_EQ(quoted_line("\x1b[2J\x7f"), "'\\x1b[2J\\x7f'");
  EXPECT_EQ(quoted_line("move\xC2\xA0"), "'move\\xc2\\xa0'");
}

TEST(QuotedLine, NamesAByteOrderMarkAtItsBegin) {
  EXPECT_THAT(quoted_line("\xEF\xBB\xBFlabmouse 1"), Says("'\\ufefflabmouse 1' ", "begins", "byte-order mark"));
  EXPECT_THAT(quoted_line("labmouse\xEF\xBB\xBF"), Not(Says("mark")));
  EXPECT_EQ(quoted_line("\xEF\xBB"), "'\\xef\\xbb'");
}

TEST(QuotedLine, NamesACarriageReturnAtItsEnd) {
  EXPECT_THAT(quoted_line("move 0 1\r"), Says("'move 0 1\\r' ", "ends", "carriage return"));
  EXPECT_EQ(quoted_line("a\rb"), "'a\\rb'");
}

TEST(QuotedLine, ShowsTheBeginningOfALongOne) {
  EXPECT_EQ(quoted_line(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
  EXPECT_EQ(quoted_line(std::string(61, 'x')), "'" + std::string(60, 'x') + "...'");
}

}  // namespace
}  // namespace labmouse
