#include "labmouse/lab/league/season.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/league/league.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {
namespace {

using ::testing::SizeIs;
using namespace std::chrono_literals;

Season some_season() {
  Season season;
  season.title = R"(The "first" season)";
  season.is_frozen = true;
  season.version = "1.2.3";
  season.world = {find_world("physical"), {{"robot", "classic"}, {"noise", "0.5"}}};
  season.examination = {7, "prim", 12};
  season.seed_hash = sha256_text("wet chalk and 41 lemons");
  season.limits.decision = 250ms;
  season.limits.memory = std::uint64_t{512} << 20U;
  season.limits.processes = 3;
  return season;
}

/// A season file with that line.
SeasonResult with(const std::string& line) {
  return read_season(line + "\nexamination_seed_sha256 = \"" + std::string(64, 'a') + "\"\n");
}

TEST(SeasonFile, IsReadAsItWasWritten) {
  const std::string text = season_text(some_season());
  const SeasonResult read = read_season(text);
  ASSERT_THAT(read.problems, SizeIs(0)) << text;
  const Season& season = read.season;
  EXPECT_EQ(season.title, R"(The "first" season)");
  EXPECT_EQ(season.version, "1.2.3");
  EXPECT_EQ(season.world.entry->name, "physical");
  EXPECT_EQ(season.world.settings.at("robot"), "classic");
  EXPECT_EQ(season.world.settings.at("noise"), "0.5");
  EXPECT_EQ(season.examination.count, 7);
  EXPECT_EQ(season.examination.kind, "prim");
  EXPECT_EQ(season.examination.side, 12);
  EXPECT_EQ(season.limits.decision, 250ms);
  EXPECT_EQ(season.limits.start, ExternalLimits().start);
  EXPECT_EQ(season.limits.memory, std::uint64_t{512} << 20U);
  EXPECT_EQ(season.limits.processes, 3);
  EXPECT_EQ(season_text(season), text);
  const std::string shortest = season_text(with("").season);
  EXPECT_EQ(season_text(read_season(shortest).season), shortest) << shortest;
}

TEST(SeasonFile, RefusesWhatIsNoSeason) {
  EXPECT_THAT(with("title = \"x\"").problems, SizeIs(0));
  for (const char* line :
       {"titel = \"x\"", "world = \"moon\"", "settings = { budget = 0 }", "settings = { colour = 1 }",
        "limits = { start = -1 }", "examination = { count = 0 }", "examination = { kind = \"x\" }",
        "examination = { kind = \"contest\", side = 3 }", "examination = 3"})
    EXPECT_THAT(with(line).problems, SizeIs(1)) << line;
  EXPECT_THAT(read_season("title = \"x\"").problems, SizeIs(1));
  EXPECT_THAT(read_season("examination_seed_sha256 = \"abc\"").problems, SizeIs(1));
  EXPECT_THAT(read_season("examination_seed_sha256 = \"" + std::string(64, 'A') + "\"").problems, SizeIs(1));
}

TEST(SeasonFile, NeedsAWorldWhoseScoresHaveABestOne) {
  for (const WorldEntry* world : all_worlds()) {
    const auto made = world->make({}).world;
    EXPECT_EQ(refuse_for_league(*made).empty(), made->traits().has_ratio) << world->name;
  }
}

TEST(SecretSeed, IsTheFirstLineThatIsNoComment) {
  EXPECT_EQ(secret_in(secret_text("wet chalk")), "wet chalk");
  EXPECT_EQ(secret_in("\n # no\n  wet chalk \r\nmore"), "wet chalk");
  EXPECT_EQ(secret_in("wet chalk"), "wet chalk");
  EXPECT_EQ(secret_in("# nothing\n\n"), "");
  EXPECT_EQ(secret_in(""), "");
}

TEST(SecretSeed, DeterminesTheMazes) {
  const std::vector<NamedMaze> one = examination_mazes({3, "contest", 8}, "wet chalk");
  const std::vector<NamedMaze> more = examination_mazes({5, "contest", 8}, "wet chalk");
  const std::vector<NamedMaze> other = examination_mazes({3, "contest", 8}, "dry chalk");
  ASSERT_THAT(one, SizeIs(3));
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].name, more[i].name);
    EXPECT_TRUE(one[i].maze == more[i].maze);
    EXPECT_FALSE(one[i].maze == other[i].maze);
  }
  EXPECT_FALSE(one[0].maze == one[1].maze);
}

// The number for contests stands in public files: it is no seed of a maze.
TEST(SecretSeed, GivesEachPurposeItsOwnNumber) {
  EXPECT_NE(number_from("wet chalk", "contests"), number_from("wet chalk", "examination 001"));
  EXPECT_EQ(number_from("wet chalk", "contests"), number_from("wet chalk", "contests"));
  EXPECT_LT(number_from("wet chalk", "contests"), std::uint64_t{1} << 53U);
}

}  // namespace
}  // namespace labmouse
