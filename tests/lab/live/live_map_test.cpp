// The map that the lines of a real robot give, and what contradicts in them.
#include "labmouse/lab/live/live_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "labmouse/lab/live/live_drawing.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

using Found = LiveFinding::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What a map finds in lines.
std::vector<LiveFinding> add(LiveMap& map, std::string_view lines) {
  std::vector<LiveFinding> all;
  for (const LiveLine& line : LiveReader().feed(lines))
    for (const LiveFinding& finding : map.add(line)) all.push_back(finding);
  return all;
}

std::vector<Found> kinds_of(const std::vector<LiveFinding>& findings) {
  std::vector<Found> kinds;
  for (const LiveFinding& finding : findings) kinds.push_back(finding.kind);
  return kinds;
}

TEST(LiveMap, GrowsAsTheRobotSeesIt) {
  LiveMap map(Size{3, 2});
  EXPECT_EQ(map.map().unseen, WallSet::all({3, 2}));
  EXPECT_EQ(map.pose(), std::nullopt);
  EXPECT_THAT(add(map, "0 0 N 101\n0 1 E 1?0\n1 1 E ???\n"), IsEmpty());
  EXPECT_EQ(*write_partial_map(map.map()).content,
            "o---o---o---o\n"
            "|   : G :   |\n"
            "o   o...o...o\n"
            "| S | G :   |\n"
            "o---o---o---o\n");
  EXPECT_EQ(map.pose(), (Pose{{1, 1}, Heading::east}));
  EXPECT_EQ(map.cells().count(), 3);
}

TEST(LiveMap, TakesTheNewestReadingAndListsContradictions) {
  LiveMap map(Size{3, 3});
  const auto findings = add(map, "0 0 N 100\n1 0 N 100\n2 0 N 001\n1 0 N 101\n0 0 N 101\n");
  ASSERT_THAT(kinds_of(findings), ElementsAre(Found::contradiction, Found::contradiction));
  // The wall between (0,0) and (1,0).
  EXPECT_EQ(findings[0].now, (WallReading{{1, 0}, Heading::west, true, 2}));
  EXPECT_EQ(findings[0].before, (WallReading{{0, 0}, Heading::east, false, 1}));
  EXPECT_EQ(words_of(findings[0]), "line 2: the wall west of (1,0) is closed, but open in line 1, seen from (0,0)");
  EXPECT_EQ(findings[1].now, (WallReading{{1, 0}, Heading::east, true, 4}));
  EXPECT_FALSE(map.map().known.is_open({1, 0}, Heading::east));
  const auto all = map.contradictions();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].now->line, 5);
  EXPECT_EQ(all[0].before->line, 1);
}

TEST(LiveMap, FindsWallsThatCannotBe) {
  LiveMap map(Size{3, 3});
  const auto findings = add(map, "0 0 N 001\n3 0 N 101\n");
  ASSERT_THAT(kinds_of(findings), ElementsAre(Found::open_border, Found::outside));
  EXPECT_EQ(findings[0].now, (WallReading{{0, 0}, Heading::west, false, 1}));
  EXPECT_EQ(map.pose()->cell, (Cell{0, 0}));
}

TEST(LiveMap, NoticesRestarts) {
  LiveMap map(Size{3, 3});
  EXPECT_THAT(kinds_of(add(map, "start\n0 0 N 101\n0 1 N 101\n0 0 S ???\n0 1 N 101\nbatt=3\n")),
              ElementsAre(Found::restart));
  EXPECT_EQ(map.restarts(), 1);
  EXPECT_EQ(map.fields().at("batt"), "3");
  // It comes home from the neighbour; it is carried from elsewhere.
  const auto carried = add(map, "0 2 N 111\n0 0 N 101\n");
  ASSERT_THAT(kinds_of(carried), ElementsAre(Found::restart));
  EXPECT_EQ(carried[0].cell, (Cell{0, 0}));
  EXPECT_THAT(map.fields(), IsEmpty());
  EXPECT_EQ(add(map, "start\n").size(), 1U);
  EXPECT_EQ(map.pose(), std::nullopt);
  EXPECT_FALSE(map.map().known.is_open({0, 2}, Heading::east)) << "the maze is the same";
}

TEST(LiveMap, TakesDrawings) {
  LiveMap map(Size{2, 2});
  std::vector<LiveFinding> findings;
  for (const LiveLine& line :
       LiveReader(Size{2, 2}).feed("0 0 N 100\no---o---o\n|   :   |\no   o...o\n|   |   |\no---o---o\n1 0 N 010\n"))
    for (const LiveFinding& finding : map.add(line)) findings.push_back(finding);
  ASSERT_THAT(kinds_of(findings), ElementsAre(Found::contradiction, Found::open_border, Found::contradiction));
  EXPECT_EQ(findings[0].now, (WallReading{{0, 0}, Heading::east, true, 6, true}));
  EXPECT_EQ(words_of(findings[2]), "line 7: the wall west of (1,0) is open, but closed in line 6, drawn by the robot");
  EXPECT_EQ(map.map().unseen.count(), 1);
}

const Maze& truth() {
  static const Maze maze = test::drawn(R"(
    o---o---o
    |       |
    o   o   o
    | S |   |
    o---o---o
  )");
  return maze;
}

TEST(LiveMap, FindsFalseAndMissedWallsOfAKnownMaze) {
  LiveMap map(truth());
  EXPECT_THAT(kinds_of(add(map, "0 0 N 100\n")), ElementsAre(Found::missed_wall));
  EXPECT_THAT(add(map, "0 0 N 100\n"), IsEmpty()) << "it is known";
  EXPECT_THAT(kinds_of(add(map, "1 0 N 101\n")), ElementsAre(Found::contradiction)) << "it is right now";
  const auto findings = add(map, "1 0 N 011\n");
  EXPECT_THAT(kinds_of(findings),
              ElementsAre(Found::contradiction, Found::false_wall, Found::contradiction, Found::missed_wall));
  EXPECT_EQ(findings[1].now, (WallReading{{1, 0}, Heading::north, true, 1}));
  const std::string drawn = draw_live(map, false);
  EXPECT_THAT(drawn, HasSubstr("o   o%%%o"));
  EXPECT_THAT(drawn, HasSubstr("GS #"));
}

TEST(LiveMap, HasTheRouteThatTheRobotPlans) {
  LiveMap map(Size{4, 4});
  add(map, "0 0 N 101 route=NNEES\n");
  EXPECT_EQ(
      map.route(),
      (std::vector<Pose>{
          {{0, 0}, Heading::north}, {{0, 2}, Heading::north}, {{2, 2}, Heading::east}, {{2, 1}, Heading::south}}));
  add(map, "0 1 N 101\n");
  EXPECT_THAT(map.route(), IsEmpty()) << "it began elsewhere";
  add(map, "route=SS\n");
  EXPECT_EQ(map.route().size(), 2U) << "it ends at the border";
  EXPECT_EQ(map.route().back().cell, (Cell{0, 0}));
}

TEST(LiveMap, KeepsFewFields) {
  LiveMap map(Size{4, 4});
  for (int i = 0; i < 1000; ++i) add(map, "f" + std::to_string(i) + "=1\n");
  EXPECT_EQ(map.fields().size(), LiveMap::most_fields);
  add(map, "f0=2\n");
  EXPECT_EQ(map.fields().at("f0"), "2");
}

TEST(LiveMap, IsDrawnWithItsCounts) {
  LiveMap map(Size{2, 2});
  LiveReader reader;
  for (const LiveLine& line : reader.feed("0 0 N 101 batt=7900 state=search\nnoise\n")) map.add(line);
  EXPECT_EQ(draw_live(map, false),
            "   o---o---o\n"
            " 1 | G : G |\n"
            "   o   o- -o\n"
            " 0 |S^ | G |\n"
            "   o---o---o\n"
            "     0   1\n");
  EXPECT_EQ(live_summary(map, reader),
            "2 of 4 inner walls seen from 1 cell; 0 contradictions, 0 restarts; 2 lines, 1 of noise\n"
            "batt=7900 state=search\n");
}

}  // namespace
}  // namespace labmouse
