// Mazes on the command line: made, converted, described, compared with maps, and found in files and folders.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::json;
using test::AUser;
using test::corridor;
using test::Ended;
using test::Says;
using ::testing::HasSubstr;

TEST_F(AUser, IsToldWhereAMazeFileIsBad) {
  file("bad.txt", "o---o---o\n| S   X |\no---o---o\n");
  is_refused({"show", "bad.txt"}, "bad.txt:2:");
  is_refused({"race", "--mazes", "bad.txt"}, "bad.txt:2:");
}

TEST_F(AUser, RacesOnWhereAFolderHoldsABadFile) {
  std::filesystem::create_directories(folder_ / "mazes");
  file("mazes/bad.txt", "rubbish");
  file("mazes/fine.txt", corridor);
  const Ended ended = labmouse({"race", "--mazes", "mazes", "--format", "json"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.err, HasSubstr("mazes/bad.txt"));
  const Json json = Json::parse(ended.out);
  EXPECT_EQ(json.at("groups").at(0).at("mazes").size(), 1U);
  EXPECT_EQ(json.at("skipped").at(0).at("path"), "mazes/bad.txt");
}

TEST_F(AUser, OverridesStartAndGoal) {
  file("corridor.txt", corridor);
  EXPECT_THAT(labmouse({"run", "flood", "corridor.txt", "--goal", "1,0"}).out, HasSubstr("1 speed"));
  EXPECT_THAT(labmouse({"run", "flood", "corridor.txt", "--start", "2,0,west", "--goal", "0,0"}).out,
              HasSubstr("bound 1.067"));
}

TEST_F(AUser, MakesConvertsAndShowsAMaze) {
  ASSERT_EQ(labmouse({"bound", "capstone-1"}).code, 0);
  const Ended made = labmouse({"make", "prim", "--seed", "4"});
  EXPECT_EQ(made.code, 0);
  EXPECT_EQ(made.out, labmouse({"make", "prim", "--seed", "4"}).out);
  EXPECT_NE(made.out, labmouse({"make", "prim", "--seed", "5"}).out);
  file("made.txt", made.out);
  EXPECT_EQ(labmouse({"convert", "made.txt", "made.num"}).code, 0);
  EXPECT_EQ(labmouse({"show", "made.num"}).code, 0);
}

TEST_F(AUser, ConvertsWhatOthersWriteAndIsToldHowItWasRead) {
  file("array.h", "const int m[2][2] = {{14, 9}, {14, 3}};\n");
  const Ended converted = labmouse({"convert", "array.h", "-"});
  EXPECT_EQ(converted.code, 0);
  EXPECT_EQ(converted.out, "o---o---o\n| G   G |\no   o   o\n| G | G |\no---o---o\n");
  EXPECT_THAT(converted.err, Says("array.h", "2x2", "columns from the west", "1 north"));
  EXPECT_THAT(labmouse({"inspect", "array.h"}).out, Says("columns from the west"));
  file("gap.txt", "o---o---o\n|        \no---o---o\n");
  EXPECT_THAT(labmouse({"show", "gap.txt"}).err, Says("gap.txt", "east of (1,0)"));
}

TEST_F(AUser, ConvertsWhatDoesNotSayEnough) {
  file("odd.num", "0 0 0 1 1 1\n0 1 1 1 0 1\n1 0 0 1 1 1\n1 1 1 1 0 0\n");
  const Ended refused = labmouse({"convert", "odd.num", "even.num"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, Says("odd.num:4:1", "(1,1)", "--repair"));
  const Ended repaired = labmouse({"convert", "odd.num", "even.num", "--repair", "--from", "num", "--transpose"});
  EXPECT_EQ(repaired.code, 0);
  EXPECT_THAT(repaired.err, Says("note", "(1,1)", "closed"));
  EXPECT_EQ(labmouse({"convert", "even.num", "-", "--format", "num"}).out,
            "0 0 1 0 1 1\n0 1 1 0 1 1\n1 0 1 1 1 0\n1 1 1 1 1 0\n");
  is_refused({"convert", "odd.num", "even.num", "--from", "nul"}, "'nul'", "'num'");
  file("partial.txt", "o---o---o\n| G |   |\no   o   o\n| S :   |\no---o---o\n");
  is_refused({"convert", "partial.txt", "whole.txt"}, "partial.txt", "partial map", "--against");
  EXPECT_EQ(labmouse({"convert", "partial.txt", "-", "--close-unseen"}).out,
            "o---o---o\n| G |   |\no   o   o\n| S |   |\no---o---o\n");
  const Ended shown = labmouse({"show", "partial.txt"});
  EXPECT_THAT(shown.out, Says(":   |"));
  EXPECT_THAT(shown.err, Says("note", "1 of 4"));
  EXPECT_EQ(labmouse({"run", "flood", "partial.txt"}).code, 0);
  EXPECT_EQ(labmouse({"route", "partial.txt"}).code, 0);
  file("gap.txt", "o---o---o\n|        \no---o   o\n");
  EXPECT_EQ(labmouse({"convert", "gap.txt", "-", "--border-gaps"}).code, 2);
  file("gaps.txt", "o---o---o\n         \no---o---o\n");
  EXPECT_EQ(labmouse({"convert", "gaps.txt", "-", "--border-gaps", "--format", "drawing"}).code, 2);
}

TEST_F(AUser, SeparatesMazesAndGoalsByCommas) {
  file("corridor.txt", corridor);
  file("a,b.txt", corridor);
  EXPECT_THAT(labmouse({"inspect", "corridor.txt,a,b.txt"}).err, Says("a: error"));
  EXPECT_THAT(labmouse({"inspect", "corridor.txt,capstone-1"}).out, Says("corridor.txt", "capstone-1"));
  EXPECT_THAT(labmouse({"inspect", "a,b.txt"}).out, Says("a,b.txt"));
  const Ended two = labmouse({"show", "capstone-1", "--goal", "0,1,2,3"});
  EXPECT_EQ(two.out, labmouse({"show", "capstone-1", "--goal", "0,1", "--goal", "2,3"}).out);
  is_refused({"show", "capstone-1", "--goal", "0,1,2"}, "'0,1,2'", "X,Y");
}

TEST_F(AUser, ComparesTheMapOfARobotWithTheMaze) {
  file("true.hex", "93\nee\n");
  file("robot.log", "0 0 N 101\n0 1 N 111\n");
  const Ended compared = labmouse({"inspect", "robot.log", "--against", "true.hex", "--check"});
  EXPECT_EQ(compared.code, 1);
  EXPECT_THAT(compared.out, Says("robot.log", "true.hex", "2 right", "1 wrong", "1 unseen", "east of (0,1)"));
  EXPECT_EQ(labmouse({"inspect", "true.hex", "--against", "true.hex", "--check"}).code, 0);
  is_refused({"inspect", "true.hex", "--against", "capstone-1"}, "2x2", "12x12");
  const Ended drawn = labmouse({"show", "robot.log", "--against", "true.hex"});
  EXPECT_THAT(drawn.out, Says("robot.log", "2 right", "1 wrong", "1 unseen", "%", "- -"));
  EXPECT_EQ(labmouse({"show", "robot.log", "--against", "true.hex", "--svg", "map.svg"}).code, 0);
  EXPECT_THAT(content("map.svg"), Says("false wall", "missed wall"));
  is_refused({"show", "robot.log", "--against", "true.hex", "--layer", "heat"}, "heat", "record");
  is_refused({"show", "--record", "robot.log", "--against", "true.hex"}, "--against", "--maze");
  is_refused({"bound", "robot.log"}, "robot.log", "partial map", "--against");
  is_refused({"inspect", "--against", "true.hex"}, "--against", "name the files");
}

TEST_F(AUser, IsToldWhatCannotBeWritten) {
  file("corridor.txt", corridor);
  is_refused({"make", "prim", "-o", "corridor.txt/maze.txt"}, "corridor.txt/maze.txt: error: ", "not a folder");
}

}  // namespace
}  // namespace labmouse
