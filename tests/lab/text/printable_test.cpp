#include "labmouse/lab/text/printable.hpp"

#include <gtest/gtest.h>

namespace labmouse {
namespace {

std::string shown(std::string_view text) { return utf8(printable(text)); }

TEST(Printable, KeepsValidTextOfEveryLength) {
  EXPECT_EQ(shown("maze é € 🐭"), "maze é € 🐭");
  EXPECT_EQ(printable("é€🐭").size(), 3U);
}

TEST(Printable, TurnsBreaksIntoSpacesAndDropsControls) {
  EXPECT_EQ(shown("a\tb\nc"), "a b c");
  EXPECT_EQ(shown("\x1b[31mred\x07\x7f"), "[31mred");
  EXPECT_EQ(shown("C1 \xc2\x9b."), "C1 .");
}

TEST(Printable, DropsWhatReordersALine) {
  EXPECT_EQ(shown("a\xe2\x80\xae"
                  "b\xef\xbb\xbf"),
            "ab");
}

TEST(Printable, ReplacesEachInvalidByte) {
  EXPECT_EQ(shown("\xff"), "\uFFFD");
  EXPECT_EQ(shown("\xc3"), "\uFFFD");                      // cut off
  EXPECT_EQ(shown("\xc3("), "\uFFFD(");                    // no continuation
  EXPECT_EQ(shown("\xc0\xaf"), "\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(shown("\xe0\x80\xaf"), "\uFFFD\uFFFD\uFFFD");  // overlong
  EXPECT_EQ(shown("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");  // surrogate
  EXPECT_EQ(shown("\xf4\x90\x80\x80").size(), 4 * 3U);     // past U+10FFFF
}

TEST(Printable, EscapesXml) { EXPECT_EQ(xml_escaped("<a b='\"'>&\x01"), "&lt;a b=&#39;&quot;&#39;&gt;&amp;"); }

TEST(CsvField, IsQuotedWhereItMustBe) {
  EXPECT_EQ(csv_field("contest 1.txt"), "contest 1.txt");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("\"a\"\n"), "\"\"\"a\"\"\n\"");
}

}  // namespace
}  // namespace labmouse
