// Reasons from end to end: in words, in records, in pictures.
#include <sstream>

#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using test::AUser;
using test::Ended;
using test::Says;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// The explanation in what was printed, which stands below the result.
std::string explanation_in(const std::string& out) { return out.substr(std::min(out.find("\nT: "), out.size())); }

TEST_F(AUser, IsToldWhyAMouseWentWhereItWent) {
  const Ended plain = labmouse({"run", "ariadne", "capstone-1"});
  const Ended told = labmouse({"run", "ariadne", "capstone-1", "--explain"});
  EXPECT_EQ(told.code, 0);
  EXPECT_EQ(told.err, "");
  EXPECT_THAT(told.out, StartsWith(plain.out));
  const std::string explanation = explanation_in(told.out);
  EXPECT_THAT(explanation, HasSubstr("\nstep 1 at (0,0) heading north"));
  EXPECT_THAT(explanation, HasSubstr(": reset"));
  std::istringstream lines(explanation);
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 80U) << line;
    rows = line.substr(0, 5) == "step " ? 0 : rows + 1;
    EXPECT_LE(rows, 1 + 5 + 2) << "the columns, the candidates, how many more, and an empty line";
  }
}

TEST_F(AUser, ChoosesHowManyCandidatesAreShown) {
  const std::string two = labmouse({"run", "ariadne", "capstone-1", "--explain", "--candidates", "2"}).out;
  const std::string all = labmouse({"run", "ariadne", "capstone-1", "--explain", "--candidates", "9999"}).out;
  EXPECT_THAT(two, HasSubstr("    and "));
  EXPECT_THAT(all, Not(HasSubstr("    and ")));
  EXPECT_GT(all.size(), two.size());
  is_refused({"run", "ariadne", "capstone-1", "--candidates", "2"}, "--explain");
  is_refused({"run", "ariadne", "capstone-1", "--explain", "--candidates", "0"}, "--candidates");
}

TEST_F(AUser, IsToldThatAMouseHasNoReasons) {
  const Ended told = labmouse({"run", "flood", "capstone-1", "--explain"});
  EXPECT_EQ(told.code, 0);
  const std::string plain = labmouse({"run", "flood", "capstone-1"}).out;
  ASSERT_THAT(told.out, StartsWith(plain));
  EXPECT_THAT(told.out.substr(plain.size()), Says("flood", "no reasons"));
}

TEST_F(AUser, FindsReasonsInARecordOnlyWhereTheyWereAskedFor) {
  ASSERT_EQ(labmouse({"run", "ariadne", "capstone-1", "--record", "plain.jsonl"}).code, 0);
  const Ended told = labmouse({"run", "ariadne", "capstone-1", "--explain", "--record", "told.jsonl"});
  EXPECT_THAT(content("plain.jsonl"), Not(HasSubstr("reasons")));
  EXPECT_THAT(content("told.jsonl"), HasSubstr("\"reasons\":{\"candidates\":["));
  EXPECT_EQ(labmouse({"replay", "told.jsonl", "--explain"}).out, told.out);
  EXPECT_EQ(labmouse({"replay", "told.jsonl"}).out, labmouse({"replay", "plain.jsonl"}).out);
  const Ended nothing = labmouse({"replay", "plain.jsonl", "--explain"});
  EXPECT_EQ(nothing.code, 0);
  EXPECT_THAT(nothing.out, Says("no reasons", "--explain", "--record"));
}

TEST_F(AUser, SeesTheCandidatesOfAStep) {
  ASSERT_EQ(labmouse({"run", "ariadne", "capstone-1", "--explain", "--record", "walk.jsonl"}).code, 0);
  const Ended first =
      labmouse({"show", "--record", "walk.jsonl", "--layer", "candidates,known", "--step", "1", "--svg", "1.svg"});
  EXPECT_EQ(first.code, 0);
  EXPECT_EQ(first.out + first.err, "");
  EXPECT_THAT(content("1.svg"), HasSubstr("<title>ariadne in capstone-1: step 1 of "));
  EXPECT_THAT(content("1.svg"), HasSubstr(" of step 1, with "));
  ASSERT_EQ(labmouse({"show", "--record", "walk.jsonl", "--layer", "candidates", "--svg", "last.svg"}).code, 0);
  EXPECT_THAT(content("last.svg"), HasSubstr("<title>ariadne in capstone-1: score "));
  EXPECT_THAT(content("last.svg"), HasSubstr(">none chosen<"));
}

TEST_F(AUser, SeesARecordAsFarAsAStep) {
  ASSERT_EQ(labmouse({"run", "flood", "capstone-1", "--record", "walk.jsonl"}).code, 0);
  const Ended shown = labmouse({"show", "--record", "walk.jsonl", "--layer", "search", "--step", "19"});
  EXPECT_EQ(shown.err, "");
  EXPECT_THAT(shown.out,
              testing::AllOf(Says("+ 19 steps", "no goal"), EndsWith("\nflood in capstone-1: step 19 of 52\n")));
  EXPECT_THAT(labmouse({"show", "--record", "walk.jsonl", "--step", "52"}).out, EndsWith(": step 52 of 52\n"));
  is_refused({"show", "--record", "walk.jsonl", "--step", "53"}, "52 steps", "step 53");
  is_refused({"show", "--record", "walk.jsonl", "--step", "0"}, "--step");
  is_refused({"show", "capstone-1", "--step", "3"}, "--step", "--record");
}

TEST_F(AUser, IsToldWhyThereAreNoCandidatesToSee) {
  ASSERT_EQ(labmouse({"run", "flood", "capstone-1", "--record", "flood.jsonl"}).code, 0);
  const Ended none = labmouse({"show", "--record", "flood.jsonl", "--layer", "candidates"});
  EXPECT_EQ(none.code, 0);
  EXPECT_THAT(none.err, Says("layer candidates", "no reasons", "--explain", "--record"));
  ASSERT_EQ(labmouse({"run", "ariadne", "capstone-1", "--explain", "--record", "walk.jsonl"}).code, 0);
  EXPECT_THAT(labmouse({"show", "--record", "walk.jsonl", "--layer", "candidates"}).err,
              Says("layer candidates", "--svg"));
  is_refused({"show", "capstone-1", "--layer", "candidates"}, "layer candidates", "--record");
}

}  // namespace
}  // namespace labmouse
