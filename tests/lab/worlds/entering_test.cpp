// Which mouse races in which world.
#include "labmouse/lab/worlds/entering.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/races/race_paths.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/lab/mms/mms_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::json;
using test::Says;
using test::SaysAt;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

const std::string program = "mms:\"" LABMOUSE_MMS_PROGRAM "\"";

std::vector<Contestant> of_two_worlds() {
  const std::vector<std::string> specs = {"flood", program};
  return read_specs(specs).contestants;
}

TEST(Entering, PutsEachMouseIntoTheFirstWorldThatTakesIt) {
  const EntriesResult found = enter(of_two_worlds(), "", {});
  ASSERT_THAT(found.entries, SizeIs(2)) << found.error;
  EXPECT_EQ(found.entries[0].world->traits().name, all_worlds().front()->name);
  EXPECT_THAT(names_of(found.entries[0].mice), ElementsAre("flood"));
  EXPECT_EQ(found.entries[1].world->traits().name, "mms");
  EXPECT_THAT(names_of(found.entries[1].mice), ElementsAre(program));
  EXPECT_THAT(enter({of_two_worlds()[1]}, "", {}).entries, SizeIs(1));
}

TEST(Entering, SaysWhichWorldsTakeAllMice) {
  const auto error = [](const std::vector<std::string>& specs) {
    return different_worlds(enter(read_specs(specs).contestants, "", {}).entries, "look elsewhere");
  };
  EXPECT_EQ(error({"flood", "certify"}), "");
  EXPECT_EQ(error({"festina"}), "");
  EXPECT_THAT(error({"flood", "festina", "certify"}),
              AllOf(Says("'flood' and 1 other", "steps", "'festina'", "--world seconds or --world physical"),
                    Not(HasSubstr("--world steps"))));
  EXPECT_THAT(error({"manhattan", "festina"}), AllOf(Says("'manhattan'", "look elsewhere"), Not(HasSubstr("--world"))));
}

TEST(Entering, GivesARaceForEachRobot) {
  const EntriesResult found = enter(read_specs("festina").contestants, "", {{"robot", "classic,half"}});
  ASSERT_THAT(found.entries, SizeIs(2)) << found.error;
  EXPECT_TRUE(has_several_values(found.entries));
  EXPECT_NE(found.entries[0].world->facts(test::loop().maze).bound,
            found.entries[1].world->facts(test::loop().maze).bound);
  EXPECT_NE(sole_entry(found.entries).error, "");
  EXPECT_FALSE(has_several_values(enter(of_two_worlds(), "", {}).entries));
  EXPECT_THAT(enter(read_specs("festina").contestants, "seconds", {{"robot", "classic,none"}}).error,
              HasSubstr("'none'"));
  EXPECT_THAT(enter(read_specs("festina").contestants, "seconds", {{"robot", "classic,"}}).error,
              Says("--robot", "'classic,'"));
}

TEST(Entering, IsRefusedByTheWorldThatIsNamed) {
  const std::vector<std::string> apart = {"manhattan", program};
  for (const WorldEntry* entry : all_worlds())
    EXPECT_THAT(enter(read_specs(apart).contestants, entry->name, {}).error, StartsWith("error: ")) << entry->name;
  EXPECT_THAT(enter({of_two_worlds()[0]}, "seconds", {{"robot", "no-robot"}}).error, HasSubstr("no-robot"));
  EXPECT_THAT(enter({of_two_worlds()[0]}, "seconds", {}).entries, SizeIs(1));
  Contestant nobody;
  nobody.name = "nobody";
  EXPECT_THAT(enter({nobody}, "", {}).error, Says("any world", "'nobody'"));
}

TEST(Entering, LeavesOutMazesInWhichAWorldHoldsNoContests) {
  const NamedMaze large = {"large", Maze(MazeDraft({60, 60}, MazeDraft::Inside::open))};
  MazeCollection collection;
  collection.mazes = {test::loop(), large};
  EXPECT_EQ(leave_out(*default_world("seconds"), {"all"}, collection), "");
  EXPECT_THAT(names_of(collection.mazes), ElementsAre("loop"));
  ASSERT_THAT(collection.skipped, SizeIs(1));
  EXPECT_EQ(collection.skipped[0].path, "large");
  collection.mazes.push_back(large);
  EXPECT_THAT(leave_out(*default_world("seconds"), {"large"}, collection), SaysAt("large", "60x60", "32x32"));
}

/// What the world with these settings is like in these mazes, and the remark.
std::pair<Entry, std::string> suited(const WorldSettings& settings, const std::vector<Size>& sizes) {
  std::vector<NamedMaze> mazes;
  for (const Size& size : sizes) mazes.push_back({"maze", Maze(MazeDraft(size, MazeDraft::Inside::open))});
  Entry entry = enter(test::mice("flood"), "failures", settings).entries.front();
  std::string remark = suit_defaults(entry, mazes);
  return {std::move(entry), std::move(remark)};
}

std::string condition_of(const Entry& entry, std::string_view key) {
  for (const Condition& condition : entry.world->traits().conditions)
    if (condition.key == key) return text_of(condition.value);
  return "";
}

TEST(Entering, RulesFollowTheSizeOfTheMazes) {
  LABMOUSE_SKIP_SANITIZED();
  const auto rules = [](const std::vector<Size>& sizes) {
    const auto [entry, remark] = suited({{"variation", "bad-day"}}, sizes);
    EXPECT_EQ(remark, "");
    EXPECT_EQ(condition_of(entry, "variation"), "1.2");
    EXPECT_THAT(names_of(entry.mice), ElementsAre("flood"));
    return Json::parse(condition_of(entry, "rules"))["name"].get<std::string>();
  };
  EXPECT_EQ(rules({{16, 16}}), "all-japan");
  EXPECT_EQ(rules({{16, 16}, {5, 3}}), "all-japan");
  EXPECT_EQ(rules({}), "all-japan");
  for (const Size& size : {Size{17, 8}, Size{8, 17}, Size{32, 32}}) EXPECT_EQ(rules({size}), "all-japan-half");
  EXPECT_EQ(rules({{17, 17}, {32, 32}}), "all-japan-half");
}

TEST(Entering, ARaceInMazesOfBothSizesHasOneSetOfRules) {
  LABMOUSE_SKIP_SANITIZED();
  const auto [entry, remark] = suited({}, {{16, 16}, {32, 32}, {16, 16}});
  EXPECT_EQ(Json::parse(condition_of(entry, "rules"))["name"], "all-japan");
  EXPECT_THAT(remark, Says("1 of 3", "all-japan", "all-japan-half", "--rules"));
  // A part of the race has the same rules.
  EXPECT_EQ(Json::parse(condition_of(suited(entry.settings, {{32, 32}}).first, "rules"))["name"], "all-japan");
}

TEST(Entering, RulesThatAreGivenHoldInMazesOfAllSizes) {
  LABMOUSE_SKIP_SANITIZED();
  for (const std::vector<Size>& sizes : {std::vector<Size>{{32, 32}}, {{16, 16}, {32, 32}}}) {
    const auto [entry, remark] = suited({{"rules", "uk"}}, sizes);
    EXPECT_EQ(remark, "");
    EXPECT_EQ(Json::parse(condition_of(entry, "rules"))["name"], "uk");
  }
}

TEST(Entering, ResidentsAreTheBuiltinMiceThatAWorldTakes) {
  EXPECT_EQ(residents_of(*first_world()).size(), builtin_mice().size());
  EXPECT_THAT(residents_of(*default_world("seconds")), Not(IsEmpty()));
  EXPECT_LT(residents_of(*default_world("seconds")).size(), all_contestants().size());
  EXPECT_THAT(residents_of(*default_world("mms")), IsEmpty());
}

}  // namespace
}  // namespace labmouse
