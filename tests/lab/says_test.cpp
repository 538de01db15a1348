// How these tests compare messages.
#include "tests/says.hpp"

#include <gtest/gtest.h>

#include "labmouse/maze/formats/read_result.hpp"

namespace labmouse {
namespace {

using test::has_part;
using test::ProblemAt;
using test::Says;
using test::SaysAt;
using ::testing::Not;

TEST(Says, TakesAllPartsInAnyOrder) {
  EXPECT_THAT("mouse 'flod' is unknown; did you mean 'flood'?", Says("'flood'", "'flod'"));
  EXPECT_THAT("mouse 'flod' is unknown", Not(Says("'flood'", "'flod'")));
  EXPECT_THAT("", Not(Says("a")));
}

TEST(Says, TakesNumbersAsAWhole) {
  for (const char* text : {"5", "at 5.", "(5)", "5,5", "15 or 5", "5 mm/s", "x5y"})
    EXPECT_TRUE(has_part(text, "5")) << text;
  for (const char* text : {"", "15", "52", "5.2", "1.5", "0.5.5.5"}) EXPECT_FALSE(has_part(text, "5")) << text;
  EXPECT_TRUE(has_part("up to 80 mm", "80 mm"));
  EXPECT_FALSE(has_part("up to 180 mm", "80 mm"));
  EXPECT_FALSE(has_part("within 63.6 mm", "6 mm"));
}

TEST(Says, AtAPlaceBeginsWithIt) {
  EXPECT_THAT("a.txt:2:5: error: is odd", SaysAt("a.txt:2:5", "odd"));
  EXPECT_THAT("a.txt:2:5: error: is odd", Not(SaysAt("a.txt", "odd")));
  EXPECT_THAT("a.txt:2:5: error: is odd", Not(SaysAt("a.txt:2:5", "even")));
  EXPECT_THAT((Problem{2, 5, "is odd"}), ProblemAt(2, 5, "odd"));
  for (const Problem& other : {Problem{2, 4, "is odd"}, Problem{1, 5, "is odd"}, Problem{2, 5, "is even"}})
    EXPECT_THAT(other, Not(ProblemAt(2, 5, "odd")));
}

}  // namespace
}  // namespace labmouse
