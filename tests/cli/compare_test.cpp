// `labmouse compare` from end to end.
#include <nlohmann/json.hpp>

#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using test::AUser;
using test::corridor;
using test::Ended;
using test::Says;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(AUser, ComparesMiceUntilItIsDecided) {
  const std::vector<std::string> words = {"compare", "slow=random", "flood", "--size", "6x6", "--generator", "prim"};
  const Ended ended = labmouse(words);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_THAT(ended.out, Says("against slow", "prim, 6x6", "flood", "better", "5 %"));
  std::vector<std::string> as_json = words;
  as_json.insert(as_json.end(), {"--format", "json", "--store", "all.db"});
  const auto json = nlohmann::json::parse(labmouse(as_json).out);
  EXPECT_EQ(json["first"], "slow");
  EXPECT_EQ(json["candidates"][0]["verdict"], "better");
  EXPECT_EQ(json["mazes"]["width"], 6);
  // What is in the store is not run again, and says the same.
  const Ended again = labmouse(as_json);
  EXPECT_EQ(nlohmann::json::parse(again.out), json);
  EXPECT_THAT(again.err, HasSubstr(" 0 added"));
}

TEST_F(AUser, ComparesInMazesOfTheirOwn) {
  file("corridor.txt", corridor);
  const Ended ended = labmouse({"compare", "flood", "flood:stride=1", "--mazes", "corridor.txt", "island-8"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, Says("2 mazes of a list", "flood:stride=1", "exact"));
  EXPECT_THAT(ended.out, Not(HasSubstr("undecided")));
}

TEST_F(AUser, ComparesWithProgramsAndHearsOfThoseThatDoNotStart) {
  file("corridor.txt", corridor);
  file("still.py",
       "import sys\nprint('labmouse 1', flush=True)\nfor line in sys.stdin:\n  print('forfeit', flush=True)\n");
  const auto compared = [&](const std::string& program) {
    return labmouse({"compare", "flood", "it=program:" + program, "--mazes", "corridor.txt", "--format", "json",
                     "--sandbox", "off"});
  };
  const Ended ended = compared("python3 still.py");
  EXPECT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_EQ(json["candidates"][0]["verdict"], "worse");
  EXPECT_FALSE(json["exact"]) << "nobody knows whether it is stochastic";
  const Ended none = compared("false");
  EXPECT_EQ(none.code, 1);
  // Two lines on what is not protected without a sandbox, and one on why it never started.
  EXPECT_EQ(std::count(none.err.begin(), none.err.end(), '\n'), 3) << none.err;
  EXPECT_EQ(nlohmann::json::parse(none.out)["candidates"][0]["verdict"], "undecided");
}

TEST_F(AUser, IsToldWhatCannotBeCompared) {
  is_refused({"compare", "flood"}, "two mice");
  is_refused({"compare", "flood", "flood"}, "two mice");
  is_refused({"compare", "flood", "flod"}, "'flod'", "'flood'");
  is_refused({"compare", "flood", "certify", "--generator", "pim"}, "'pim'", "'prim'");
  is_refused({"compare", "flood", "certify", "--size", "6y6"}, "'6y6'", "WIDTHxHEIGHT");
  is_refused({"compare", "flood", "certify", "--better-by", "0.6"}, "--better-by", "0.0001", "0.5");
  is_refused({"compare"}, "mice");
  // Also where the help of another command explains the option.
  is_refused({"compare", "flood", "certify", "--seed", "-1"}, "--seed", "'-1'");
  is_refused({"study", "--mice", "flood,certify", "--jobs", ""}, "--jobs", "empty");
  is_refused({"compare", "flood", "certify", "--mazes", "island-8", "--size", "8x8"}, "--size", "--mazes");
  is_refused({"compare", "flood", "certify", "--start", "1,1"}, "--start", "--mazes");
  is_refused({"compare", "flood", "certify", "--external-runs", "2"}, "--external-runs");
  is_refused({"compare", "flood", "certify", "--world", "seconds", "--generator", "prim", "--size", "40x40"}, "40x40",
             "32x32");
  is_refused({"compare", "flood", "certify", "--runs", "3"}, "--runs");
}

}  // namespace
}  // namespace labmouse
