#include "labmouse/lab/records/mms_record.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "labmouse/lab/bounds/mms_bound.hpp"
#include "labmouse/lab/pictures/mms_picture.hpp"
#include "labmouse/lab/replays/mms_summary.hpp"
#include "tests/lab/mms/mms_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::ordered_json;
using test::imagined_run;
using test::loop;
using test::plank;
using test::Says;
using test::shaft;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) list.push_back(line);
  return list;
}

TEST(MmsReport, PutsTheScoreBesideTheBound) {
  const std::string text = report_of("./mouse", plank(), imagined_run(2, 0, 24, 9));
  const MmsBound bound = mms_bound_of(plank().maze);
  EXPECT_THAT(text, Says("./mouse in plank: score 5.3", "2 best run", "33 total / 10",
                         fmt::format("bound {:g}", *bound.score)));
  EXPECT_THAT(text, Says("complete", "exit code 0", "20 lines", "12.5 s"));
  EXPECT_THAT(report_of("./mouse", shaft(), {}), Says("unfinished", "2000", "centre"));
}

TEST(MmsReport, SaysWhatWasWrong) {
  MmsRun run;
  run.invalid_lines = 2;
  run.log = {"line 3: 'turnright' is no command", "line 4: '' is no command"};
  run.errors = "Traceback\n  File \x1b[31m\nKeyError: 'north'\n";
  const std::string text = report_of("./mouse", loop(), run);
  EXPECT_THAT(text, Says("2 lines", ":\n  line 3: 'turnright' is no command\n"));
  EXPECT_THAT(text, HasSubstr("  | KeyError: 'north'\n"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
}

/// The record of a run of these lines.
std::vector<Json> recorded(const std::vector<std::string>& asked, std::int64_t most = most_recorded_events) {
  MmsRecorder recorder("mms:./mouse", loop(), most);
  MmsHost host(loop().maze, {});
  host.on_event([&](const MmsEvent& event) { recorder.add(event); });
  std::string replies;
  for (const std::string& line : asked) host.obey(line, replies);
  MmsRun run;
  run.end = "exit code 0";
  run.statistics = host.statistics();
  std::vector<Json> record;
  for (const std::string& line : lines(recorder.finish(run))) record.push_back(Json::parse(line));
  return record;
}

TEST(MmsRecord, BeginsWithTheMazeAsMmsTakesIt) {
  const Json header = recorded({}).front();
  EXPECT_EQ(header.at("labmouse"), "mms record");
  EXPECT_EQ(header.at("format"), 1);
  EXPECT_EQ(header.at("mouse").at("name"), "mms:./mouse");
  EXPECT_EQ(header.at("maze").at("name"), "loop");
  EXPECT_EQ(header.at("maze").at("start"), Json({0, 0}));
  EXPECT_EQ(header.at("maze").at("goals"), Json({{2, 2}}));
  EXPECT_EQ(header.at("maze").at("drawing").size(), 11U);
}

TEST(MmsRecord, HasALineForWhatMovedTurnedOrDrew) {
  const auto record =
      recorded({"mazeWidth", "moveForward 2", "turnRight45", "setText 1 1 caf\xe9", "ackReset", "what"});
  ASSERT_EQ(record.size(), 6U);
  EXPECT_EQ(record[1].at("line"), "moveForward 2");
  EXPECT_EQ(record[1].at("reply"), "ack");
  EXPECT_EQ(record[1].at("place"), Json({1, 5}));
  EXPECT_EQ(record[1].at("heading"), "north");
  EXPECT_NEAR(record[1].at("clock").get<double>(), 0.79, 0.01);
  EXPECT_EQ(record[2].at("heading"), "north-east");
  EXPECT_FALSE(record[3].contains("reply"));
  EXPECT_EQ(record[4].at("place"), Json({1, 1}));
}

TEST(MmsRecord, EndsWithHowItWent) {
  const Json end = recorded({"moveForward 2"}).back();
  EXPECT_EQ(end.at("outcome"), "complete");
  EXPECT_EQ(end.at("end"), "exit code 0");
  EXPECT_EQ(end.at("statistics").at("total-distance"), 4);
}

TEST(MmsRecord, IsCutWhereItIsTooLong) {
  const auto record = recorded({"turnLeft", "turnLeft", "turnLeft", "turnLeft"}, 2);
  ASSERT_EQ(record.size(), 5U);
  EXPECT_EQ(record[3], Json({{"left_out", 2}}));
  EXPECT_EQ(recorded({"turnLeft", "turnLeft"}, 2).size(), 4U);
}

TEST(MmsDrawing, ShowsTextsColoursAndTheMouse) {
  MmsCanvas canvas(plank().maze.size());
  canvas.set_text({0, 0}, "  7  ");
  canvas.set_colour({1, 0}, 'y');
  canvas.set_colour({2, 0}, 'B');
  const DrawingLayers layers = mms_layers(canvas, {{5, 1}, Compass::south_east});
  const std::string text = draw_text(as_in_mms(plank().maze), layers, false);
  EXPECT_THAT(text, HasSubstr("|S7   G   > |"));
  EXPECT_THAT(draw_text(as_in_mms(plank().maze), layers, true), HasSubstr("30;48;5;226m"));
  EXPECT_THAT(draw_text(as_in_mms(plank().maze), layers, true), HasSubstr("97;48;5;18m"));
}

TEST(MmsDrawing, PlacesAreInCells) {
  EXPECT_EQ(place_text({{1, 1}, Compass::north}), "at (0,0) heading north");
  EXPECT_EQ(place_text({{4, 3}, Compass::north_west}), "at (1.5,1) heading north-west");
}

}  // namespace
}  // namespace labmouse
