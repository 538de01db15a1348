// The lines of a real robot, however they arrive.
#include "labmouse/lab/live/live_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace labmouse {
namespace {

constexpr std::optional<bool> unseen = std::nullopt;

LiveLine line_of(std::string_view text) {
  const auto line = read_live_line(text);
  EXPECT_TRUE(line) << text;
  return line.value_or(LiveLine{});
}

TEST(LiveLine, HasACellAndItsWalls) {
  const SeenCell seen = {{{3, 4}, Heading::east}, {true, false, true, unseen}};
  // Left, ahead and right; or north, east, south and west.
  for (const char* text : {"3 4 E 101", "3 4 E 101?", "  3 4 east 101 ", "3,4,E,101", "3;4;e;101?", "03 4 E 101",
                           "Step 17: Pos=[3, 4] Facing=E Walls=101 Move=100", "at (3,4) E 101", "3 4 E 101 *72"}) {
    EXPECT_EQ(line_of(text).seen, seen) << text;
    EXPECT_THAT(line_of(text).fields, testing::IsEmpty()) << text;
  }
  EXPECT_EQ(line_of("0 63 S ???").seen, (SeenCell{{{0, 63}, Heading::south}, {}}));
}

TEST(LiveLine, HasFields) {
  const LiveLine line =
      line_of("3 4 E 101 pose=630.5,812,-90 v=-300 ir=1,2,3,4 batt=7900 state=search route=NNE cost=12 led=on");
  EXPECT_TRUE(line.seen);
  EXPECT_EQ(line.fields, (std::vector<LiveField>{{"pose", "630.5,812,-90"},
                                                 {"v", "-300"},
                                                 {"ir", "1,2,3,4"},
                                                 {"batt", "7900"},
                                                 {"state", "search"},
                                                 {"route", "NNE"},
                                                 {"cost", "12"},
                                                 {"led", "on"}}));
  EXPECT_EQ(line_of("batt=7900 route=").fields, (std::vector<LiveField>{{"batt", "7900"}, {"route", ""}}));
  EXPECT_TRUE(line_of("start").is_restart);
  EXPECT_EQ(line_of("start mouse=anna").fields, (std::vector<LiveField>{{"mouse", "anna"}}));
}

TEST(LiveLine, IsNoiseIfItIsAnythingElse) {
  for (const char* text :
       {"", " ", "3 4", "3 4 N", "3 4 N 10", "3 4 N 10112", " 4 N 101", "3 4 X 101", "64 4 N 101", "3 -4 N 101",
        "-3 4 N 101", "3 4 N 101 batt", "3 4 N 101 batt=", "3 4 N 101 batt=x", "3 4 N 101 pose=1,2",
        "3 4 N 101 pose=1,2,3,4", "3 4 N 101 route=NX", "3 4 N 101 =1", "3 4 N 101 Batt=1", "3 4 N 101x", "3 4 N 101=x",
        "3 4 N 101 *00", "3 4 N 101 *", "3 4 N 101 *4", "3 4 N 101 *zz", "3 4 N 1\x01", "\xff\xfe 3 4 N 101", "started",
        "starting up", "mazerunner-core 1.4",
        // Lines that a reset has cut, with the next one behind them.
        "3 4 N 10 0 N 101", "3 4 0 0 N 101", "3 40 0 N 101 batt=1", "3 4 N 0 0 N 101"})
    EXPECT_FALSE(read_live_line(text)) << text;
}

TEST(LiveReader, NumbersLinesAndCountsNoise) {
  LiveReader reader;
  const auto lines = reader.feed("\n0 0 N 101\r\nrubbish\n\n0 1 N 101\n0 2 N 1");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].number, 2);
  EXPECT_EQ(lines[1].number, 5);
  EXPECT_EQ(reader.lines(), 5);
  EXPECT_EQ(reader.noise(), 1);
  EXPECT_EQ(reader.feed("01\n").size(), 1U) << "the rest of a line is kept";
}

TEST(LiveReader, DropsLinesThatAreTooLong) {
  LiveReader reader;
  const std::string text = "0 0 N 101 state=";
  const std::string longest = text + std::string(LiveReader::longest_line - text.size(), 'x');
  EXPECT_EQ(reader.feed(longest + "\n").size(), 1U);
  EXPECT_EQ(reader.feed(longest + "x\n").size(), 0U);
  EXPECT_EQ(reader.feed("0 0 N 101\n").size(), 1U);
  EXPECT_EQ(reader.noise(), 1);
}

TEST(LiveReader, WantsChecksumsOnceThereWasOne) {
  LiveReader reader;
  EXPECT_EQ(reader.feed("3 4 E 101\n").size(), 1U);
  EXPECT_EQ(reader.feed("3 4 E 101 *72\n").size(), 1U);
  EXPECT_EQ(reader.feed("3 4 E 101\n3 4 E 101 *73\n").size(), 0U);
  EXPECT_EQ(reader.feed("3 4 E 101 *72\n").size(), 1U);
  EXPECT_EQ(reader.noise(), 2);
}

constexpr std::string_view drawn_map = "o---o---o\n|  1:  0|\no   o\xC2\xB7\xC2\xB7\xC2\xB7o\n|  2|  1|\no---o---o\n";

TEST(LiveReader, ReadsTheDrawingsOfRobots) {
  LiveReader reader(Size{2, 2});
  const auto lines =
      reader.feed("maze:\n" + std::string(drawn_map) + "0 0 N 101\n" + std::string(drawn_map) + std::string(drawn_map));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(reader.noise(), 1);
  ASSERT_TRUE(lines[0].drawing);
  EXPECT_EQ(lines[0].number, 6);
  EXPECT_EQ(lines[0].drawing->unseen.count(), 2);
  EXPECT_FALSE(lines[0].drawing->known.is_open({0, 0}, Heading::east));
  EXPECT_TRUE(lines[1].seen);
  EXPECT_TRUE(lines[3].drawing);
}

TEST(LiveReader, ReadsNoDamagedDrawings) {
  LiveReader reader(Size{2, 2});
  const std::string text(drawn_map);
  // A part; one with a part of another behind it; one of another size; one with a line too few.
  EXPECT_EQ(reader.feed(text.substr(0, 20) + "\nnoise\n").size(), 0U);
  EXPECT_EQ(reader.feed(text.substr(0, 10) + text).size(), 1U);
  EXPECT_EQ(reader.feed("o---o\n|   |\no---o\n|   |\no---o\n0 0 N 101\n").size(), 1U);
  EXPECT_EQ(reader.feed("o---o---o\n|   |   |\no---o---o\n0 0 N 101\n").size(), 1U);
  EXPECT_EQ(reader.noise(), 3 + 1 + 5 + 3);
  EXPECT_EQ(reader.feed("0 0 N 101 *7e\n").size(), 1U);
  EXPECT_EQ(reader.feed(text).size(), 0U) << "it has no checksums";
}

/// Lines as robots send them, damaged ones and noise.
rc::Gen<std::string> streams() {
  static const std::vector<std::string> pieces = {"0 0 N 101\n",
                                                  "3 4 E 1?1 batt=7900\r\n",
                                                  "3 4 E 101 *72\n",
                                                  "start\n",
                                                  "3 4 ",
                                                  "N 10",
                                                  "Step 1: Pos=[0, 1] Facing=N Walls=001\n",
                                                  "batt=1 route=NNE\n",
                                                  "\n",
                                                  "o---o---o\n",
                                                  "|   |   |\n",
                                                  std::string(drawn_map),
                                                  std::string(1500, '7')};
  const auto piece =
      rc::gen::weightedOneOf<std::string>({{8, rc::gen::elementOf(pieces)}, {2, rc::gen::string<std::string>()}});
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(piece), [](const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& each : parts) text += each;
    return text;
  });
}

RC_GTEST_PROP(LiveReader, ReadsTheSameHoweverTheBytesArrive, ()) {
  const std::string text = *streams();
  LiveReader whole(Size{2, 2}), parted(Size{2, 2});
  const auto expected = whole.feed(text);
  std::vector<LiveLine> found;
  for (std::size_t i = 0; i < text.size();) {
    const auto count = *rc::gen::inRange<std::size_t>(1, 40);
    for (LiveLine& line : parted.feed(std::string_view(text).substr(i, count))) found.push_back(line);
    i += count;
  }
  RC_ASSERT(found == expected);
  RC_ASSERT(parted.lines() == whole.lines());
  RC_ASSERT(parted.noise() == whole.noise());
}

TEST(LiveReader, ReadsTheSameAtEverySplitInTwo) {
  const std::string text = "0 0 N 101\r\n3 4 E 101 *72\n\x80 junk\n3 4 E 101\nstart *40\n0 0 N 101 *5";
  const auto expected = LiveReader().feed(text);
  ASSERT_EQ(expected.size(), 3U);
  for (std::size_t i = 0; i <= text.size(); ++i) {
    LiveReader reader;
    auto found = reader.feed(text.substr(0, i));
    for (LiveLine& line : reader.feed(text.substr(i))) found.push_back(line);
    EXPECT_EQ(found, expected) << i;
  }
}

}  // namespace
}  // namespace labmouse
