#include "labmouse/lab/text/markup.hpp"

#include <gtest/gtest.h>

namespace labmouse {
namespace {

TEST(FirstTag, IsInLowerCaseAndAfterWhatMayStandBeforeIt) {
  EXPECT_EQ(first_tag("<svg/>"), "<svg/>");
  EXPECT_EQ(first_tag("\xEF\xBB\xBF \r\n<!DOCTYPE\n\t html><html>"), "<!doctype html>");
  EXPECT_EQ(first_tag("<?xml version='1.0'?>\n<!-- <html> --> <!-- x --><SVG width='1'>"), "<svg width='1'>");
  EXPECT_EQ(first_tag("text <svg>"), "");
  EXPECT_EQ(first_tag(""), "");
  EXPECT_EQ(first_tag("<!-- without end"), "");
  EXPECT_EQ(first_tag("<" + std::string(1000, 'a')).size(), 40U);
}

TEST(Markup, IsHtmlOrSvg) {
  for (const char* text :
       {"<!doctype html>", "<HTML lang='en'>", "<svg>", "<!DOCTYPE svg PUBLIC 'x'>", "<!---->\n<html>"})
    EXPECT_TRUE(is_markup(text)) << text;
  for (const char* text : {"", "+---+", "<?xml version='1.0'?><maze/>", "# <html>", "<!-- <html> -->", "<body>"})
    EXPECT_FALSE(is_markup(text)) << text;
}

}  // namespace
}  // namespace labmouse
