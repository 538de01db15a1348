// `labmouse bound --hindsight` from end to end.
#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::json;
using test::AUser;
using test::corridor;
using test::Ended;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(AUser, LooksBack) {
  const Ended ended = labmouse({"bound", "--hindsight", "two-way", "capstone-1", "island-8"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_THAT(ended.out, HasSubstr("\n   bound    score best stop best of 64  maze\n  17.600 "));
  EXPECT_THAT(ended.out, HasSubstr("mean of 2 mazes\n"));
  EXPECT_THAT(ended.out, HasSubstr("references"));
  EXPECT_THAT(labmouse({"bound", "--hindsight", "two-way", "capstone-1", "--perturbed", "0"}).out,
              Not(HasSubstr("best of")));
}

TEST_F(AUser, LooksBackAsData) {
  const auto json_with = [&](const char* jobs) {
    const Ended ended = labmouse({"bound", "capstone-1", "--hindsight", "cautious", "--runs", "4", "--perturbed", "6",
                                  "--budget", "800", "--format", "json", "--jobs", jobs});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return Json::parse(ended.out, nullptr, false);
  };
  const Json json = json_with("1");
  EXPECT_EQ(json_with("4"), json);
  EXPECT_EQ(json.at("budget"), 800);
  EXPECT_EQ(json.at("runs"), 4);
  EXPECT_EQ(json.at("others"), 6);
  const Json maze = json.at("mazes").at(0);
  EXPECT_NEAR(maze.at("bound").get<double>(), 17.6, 1e-9);
  EXPECT_LE(maze.at("best_stop"), maze.at("score"));
  // The score is that of a race with the same seed.
  const Json raced = race({"--mice", "cautious", "--mazes", "capstone-1", "--runs", "4", "--budget", "800"});
  EXPECT_NEAR(raced.at("groups").at(0).at("mice").at(0).at("mean_par1").get<double>(), maze.at("score").get<double>(),
              1e-9);
  // The best of several is what its mouse scores with its seed.
  const std::string seed = std::to_string(maze.at("best_seed").get<std::uint64_t>());
  const Ended ran = labmouse({"run", maze.at("best_mouse"), "capstone-1", "--seed", seed, "--budget", "800"});
  char score[32];
  std::snprintf(score, sizeof score, "score %.3f", maze.at("best_other").get<double>());
  EXPECT_THAT(ran.out, HasSubstr(score));
}

TEST_F(AUser, LearnsTheBoundsAsData) {
  file("closed.txt", "o---o---o\n| S | G |\no---o---o\n");
  const Json json = Json::parse(labmouse({"bound", "capstone-1", "closed.txt", "--format", "json"}).out);
  EXPECT_EQ(json, Json::parse(R"([{"name": "capstone-1", "optimum": 17, "bound": 17.6},
                                  {"name": "closed.txt", "optimum": null, "bound": null}])"));
}

TEST_F(AUser, IsToldWhatIsWrongWithHindsight) {
  is_refused({"bound", "--hindsight", "flod"}, "'flod'", "'flood'");
  is_refused({"bound", "--hindsight", "flood,certify"}, "'flood,certify'", "2 mice");
  is_refused({"bound", "capstone-1", "--perturbed", "9"}, "--perturbed", "--hindsight");
  is_refused({"bound", "capstone-1", "--seed", "9"}, "--seed", "--hindsight");
  is_refused({"bound", "--hindsight", "flood", "--perturbed", "-1"}, "--perturbed");
  is_refused({"bound", "--hindsight", "flood", "capston-1"}, "capston-1", "'capstone-1'");
}

}  // namespace
}  // namespace labmouse
