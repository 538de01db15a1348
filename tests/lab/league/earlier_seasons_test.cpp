#include "labmouse/lab/league/earlier_seasons.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/functions/sha256.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using ::testing::SizeIs;

constexpr const char* seed = "wet chalk and 41 lemons";

Json mouse(const std::string& name, int rank, double share) {
  return {{"name", name}, {"rank", rank}, {"share_of_best", share}, {"share_interval", {share / 2, share}}};
}

/// The results of a season that is over, with two mice.
Json some_results() {
  Json json = {{"labmouse", "league"},
               {"format", 1},
               {"season",
                {{"title", "Spring <1>"},
                 {"world", "steps"},
                 {"examination_mazes", 7},
                 {"examination_seed_sha256", sha256_text(seed)},
                 {"examination_seed", seed}}},
               {"mice", {mouse("ada", 1, 0.75), mouse("flood", 2, 0.5)}},
               {"earlier_seasons", Json::array()}};
  json["mice"][0]["files_sha256"] = std::string(64, 'a');
  return json;
}

std::string error_of(const Json& json) { return read_earlier_seasons(json.dump()).error; }

TEST(EarlierSeasons, AreThoseBeforeAndTheSeasonItself) {
  const EarlierSeasonsResult spring = read_earlier_seasons(some_results().dump());
  ASSERT_EQ(spring.error, "");
  ASSERT_THAT(spring.seasons, SizeIs(1));
  Json next = some_results();
  next["season"]["title"] = "Summer";
  next["earlier_seasons"] = json_of(spring.seasons);
  const EarlierSeasonsResult read = read_earlier_seasons(next.dump());
  ASSERT_EQ(read.error, "");
  ASSERT_THAT(read.seasons, SizeIs(2));
  const EarlierSeason& first = read.seasons.front();
  EXPECT_EQ(first.title, "Spring <1>");
  EXPECT_EQ(first.world, "steps");
  EXPECT_EQ(first.mazes, 7);
  EXPECT_EQ(first.seed_hash, sha256_text(seed));
  ASSERT_THAT(first.mice, SizeIs(2));
  EXPECT_EQ(first.mice[0].name, "ada");
  EXPECT_EQ(first.mice[0].hash, std::string(64, 'a'));
  EXPECT_EQ(first.mice[1].rank, 2);
  EXPECT_EQ(first.mice[1].share, 0.5);
  EXPECT_EQ(first.mice[1].interval.low, 0.25);
  EXPECT_EQ(first.mice[1].interval.high, 0.5);
  EXPECT_EQ(first.mice[1].hash, "");
  EXPECT_EQ(read.seasons.back().title, "Summer");
  EXPECT_EQ(json_of(read.seasons)[0], json_of(spring.seasons)[0]);
}

TEST(EarlierSeasons, AreOver) {
  Json json = some_results();
  json["season"].erase("examination_seed");
  EXPECT_THAT(error_of(json), test::HasParts(std::vector<std::string>{"not over", "--reveal"}));
  json["season"]["examination_seed"] = "another seed";
  EXPECT_THAT(error_of(json), test::HasParts(std::vector<std::string>{"season", "seed"}));
}

TEST(EarlierSeasons, RefuseOtherFiles) {
  EXPECT_THAT(read_earlier_seasons("").error, test::HasParts(std::vector<std::string>{"line 1"}));
  EXPECT_THAT(read_earlier_seasons("{\n\"labmouse\": x}").error,
              test::HasParts(std::vector<std::string>{"line 2", "column 13"}));
  EXPECT_EQ(read_earlier_seasons("{\"a\x1b\": 1}").error.find('\x1b'), std::string::npos);
  for (const char* text : {"[]", "3", "{}", R"({"labmouse": "race", "format": 1})", R"({"labmouse": "league"})"})
    EXPECT_NE(read_earlier_seasons(text).error, "") << text;
}

TEST(EarlierSeasons, RefuseWrongValues) {
  const auto refuses = [](const char* pointer, const Json& value) {
    for (const bool is_earlier : {false, true}) {
      Json json = some_results();
      if (is_earlier) json["earlier_seasons"] = json_of(read_earlier_seasons(json.dump()).seasons);
      Json& season = is_earlier ? json["earlier_seasons"][0] : json;
      season[Json::json_pointer(pointer)] = value;
      EXPECT_NE(error_of(json), "") << pointer << " " << value << " " << is_earlier;
    }
  };
  for (const char* name : {"", "a\nb", "\x1b[2J"}) {
    refuses("/season/title", name);
    refuses("/mice/0/name", name);
  }
  refuses("/season/title", std::string(1001, 'a'));
  refuses("/season", 3);
  refuses("/season/examination_mazes", 0);
  refuses("/season/examination_seed_sha256", std::string(64, 'A'));
  refuses("/mice", 3);
  refuses("/mice/0", 3);
  refuses("/mice/0/name", "flood");
  refuses("/mice/0/rank", 0);
  refuses("/mice/0/rank", 3);
  refuses("/mice/0/share_of_best", 1.5);
  refuses("/mice/0/share_interval", Json::array({0.1}));
  refuses("/mice/0/share_interval", Json::array({0.1, 2}));
  refuses("/mice/0/files_sha256", "abc");
  Json json = some_results();
  json["earlier_seasons"] = 3;
  EXPECT_NE(error_of(json), "");
}

}  // namespace
}  // namespace labmouse
