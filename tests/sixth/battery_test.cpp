// The program runs and shows contests in a world that only its own file and the list of worlds know.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/user.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using testing::HasSubstr;
using testing::Not;

class ASixthWorld : public test::AUser {};

TEST_F(ASixthWorld, IsRunReplayedShownAndScored) {
  const auto run = labmouse({"run", "flood", "contest-01", "--world", "battery", "--robot", "half", "--noise", "0",
                             "--record", "drive.jsonl", "--svg", "drive.svg", "--explain", "--watch"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("flood in contest-01, half"));
  EXPECT_THAT(content("drive.svg"), HasSubstr("<svg"));
  for (const char* command : {"replay", "score"}) {
    const auto shown = labmouse({command, "drive.jsonl"});
    EXPECT_EQ(shown.code, 0) << shown.err;
    EXPECT_THAT(run.out, HasSubstr(shown.out));
  }
  EXPECT_EQ(labmouse({"show", "--record", "drive.jsonl"}).code, 0);
  EXPECT_THAT(content("drive.jsonl"), HasSubstr(R"("added_world":"battery")"));
}

TEST_F(ASixthWorld, IsRacedWithItsNoiseStoredAndReported) {
  const auto finished = [&](const char* noise) {
    const auto race = labmouse({"race", "--mice", "flood", "--mazes", "contest-01", "--world", "battery", "--noise",
                                noise, "--runs", "20", "--store", "contests.db", "--format", "json"});
    EXPECT_EQ(race.code, 0) << race.err;
    return nlohmann::json::parse(race.out)["groups"][0]["mice"][0]["finished"].get<int>();
  };
  EXPECT_EQ(finished("0"), 20);
  EXPECT_LT(finished("9"), 20);
  EXPECT_THAT(labmouse({"store", "list", "contests.db"}).out, HasSubstr("battery"));
  EXPECT_EQ(labmouse({"store", "verify", "contests.db"}).code, 0);
  EXPECT_EQ(labmouse({"race", "--mice", "flood", "--mazes", "contest-01", "--world", "battery", "--out", "race"}).code,
            0);
  EXPECT_THAT(labmouse({"race", "--world", "battery", "--robot", "nobody"}).err, HasSubstr("nobody"));
}

}  // namespace
}  // namespace labmouse
