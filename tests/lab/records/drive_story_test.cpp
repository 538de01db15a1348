#include "labmouse/lab/records/drive_story.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lab/drive/physical_fixture.hpp"

namespace labmouse {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two searches that end in crashes, a third, the way home, and two speed runs; the wall north of (1, 1) turns over.
DriveRecordFile eventful() {
  DriveRecordFile file;
  file.maze = test::ring();
  file.physical = PhysicalPart{};
  const auto run = [&](DriveRun::Kind kind, MazeTime begin, MazeTime end, RunEnd how, double pace) {
    DriveRun one;
    one.kind = kind;
    one.begin = begin;
    one.end = end;
    one.pace = pace;
    one.touched = !file.record.runs.empty();
    file.record.runs.push_back(one);
    file.physical->notes.ends.push_back(how);
  };
  run(DriveRun::Kind::search, 0, 2'000'000, RunEnd::slid, 1.0);
  run(DriveRun::Kind::search, 7'000'000, 9'000'000, RunEnd::wall_error, 0.8);
  run(DriveRun::Kind::search, 14'000'000, 20'000'000, RunEnd::done, 0.64);
  run(DriveRun::Kind::home, 20'000'000, 25'000'000, RunEnd::done, 0.64);
  run(DriveRun::Kind::speed, 25'000'000, 27'000'000, RunEnd::done, 0.8);
  run(DriveRun::Kind::speed, 30'000'000, 31'000'000, RunEnd::position_lost, 1.0);
  file.record.runs[3].known = 2'000'000;
  file.record.runs[3].possible = 1'500'000;
  file.record.runs[4].gate_out = 25'200'000;
  file.record.runs[4].gate_in = 26'950'000;
  const Wall wall = {{1, 1}, Heading::north};
  file.record.walls = {{1'000'000, wall, true}, {8'000'000, wall, false}, {15'000'000, wall, false}};
  return file;
}

/// The lines of that time.
std::string at(const std::string& story, const std::string& time) {
  std::string lines;
  for (std::size_t begin = 0; begin < story.size();) {
    const std::size_t end = story.find('\n', begin);
    const std::string line = story.substr(begin, end - begin);
    if (line.find(" " + time + " ") != std::string::npos) lines += line + "\n";
    begin = end + 1;
  }
  return lines;
}

TEST(DriveStory, TellsWhyAMouseSlowedDown) {
  const std::string story = story_of(eventful());
  EXPECT_THAT(at(story, "2.000"), HasSubstr("tyres"));
  EXPECT_THAT(at(story, "7.000"), ContainsRegex("carried(.|\n)*again.*0.80.*slower"));
  EXPECT_THAT(at(story, "9.000"), HasSubstr("took for a gap"));
  EXPECT_THAT(at(story, "14.000"), ContainsRegex("0.64.*slower"));
  EXPECT_THAT(at(story, "0.000"), Not(HasSubstr("pace")));
}

TEST(DriveStory, TellsWhyItWentHomeAndRanFaster) {
  const std::string story = story_of(eventful());
  EXPECT_THAT(at(story, "20.000"), ContainsRegex("home.*2.000 s.*1.500 s"));
  EXPECT_THAT(at(story, "26.950"), HasSubstr("1.750 s"));
  EXPECT_THAT(at(story, "30.000"), HasSubstr("faster"));
}

TEST(DriveStory, TellsWhyItDroveARunAsASearch) {
  DriveRecordFile file = eventful();
  file.physical->notes.ends[4] = RunEnd::position_lost;
  DriveRun sure;
  sure.begin = 36'000'000;
  sure.end = 44'000'000;
  sure.gate_out = 36'100'000;
  sure.gate_in = 43'500'000;
  sure.open = test::ring().open_walls();
  sure.moves = {
      {36'000'000, 37'000'000, {{0, 0}, Heading::north}, Action::step(0, 1), {{0, 1}, Heading::north}, false}};
  file.record.runs.push_back(sure);
  file.physical->notes.ends.push_back(RunEnd::done);
  EXPECT_THAT(at(story_of(file), "36.000"), HasSubstr("as in a search"));
  EXPECT_THAT(at(story_of(file), "43.500"), HasSubstr("7.400 s"));
  // Over a wall that it did not know it searches.
  file.record.runs.back().open = WallSet();
  EXPECT_THAT(at(story_of(file), "36.000"), HasSubstr("searches again"));
  // And where a run had ended well, too.
  file.record.runs.back().open = test::ring().open_walls();
  file.physical->notes.ends[4] = RunEnd::done;
  EXPECT_THAT(at(story_of(file), "36.000"), HasSubstr("searches again"));
}

TEST(DriveStory, TellsWhatItLookedAtTwice) {
  const std::string story = story_of(eventful());
  EXPECT_THAT(at(story, "8.000"), ContainsRegex("north of .1, 1.*closed after all"));
  EXPECT_THAT(at(story, "15.000"), ContainsRegex("again.*closed"));
  EXPECT_EQ(at(story, "1.000"), "");
}

TEST(DriveStory, OfAContestWithoutABodyHasNothingThatGoesWrong) {
  DriveRecordFile file = eventful();
  file.physical.reset();
  EXPECT_THAT(story_of(file), Not(HasSubstr("crashes")));
}

}  // namespace
}  // namespace labmouse
