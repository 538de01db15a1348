// A contest frame by frame, as the page plays it.
#include <gmock/gmock.h>

#include "labmouse/contest/coverage.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/replays/play_frames.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::answer;
using test::data_of;
using test::error_of;
using test::json;
using test::recorded;
using test::Says;
using ::testing::HasSubstr;

json running(const std::string& mouse, const NamedMaze& maze = test::loop()) {
  return {{"mouse", mouse}, {"maze", data_of(maze)}, {"seed", 1}};
}

json play_of(const std::string& mouse, const NamedMaze& maze = test::loop()) {
  return answer("contest", running(mouse, maze))["play"];
}

/// The oracle explores by its shortest run, resets and runs: every number can be seen in the drawing of the hook.
TEST(PagePlay, HasEachFrameAndEachStep) {
  json play = play_of("oracle", test::hook());
  // Every built-in mouse can hold it again, by the same rules.
  EXPECT_EQ(play["again"]["with"], json::parse(R"({"world": "steps", "conditions": {"budget": 1000}})"));
  EXPECT_EQ(play["again"]["mice"].size(), builtin_mice().size());
  play.erase("again");
  EXPECT_TRUE(play["traits"].erase("bound"));
  json expected = json::parse(R"({
    "world": "steps", "mouse": "oracle", "rules": {"budget": 1000, "search_factor": 30, "stride": 3}, "seed": 1,
    "outcome": "finished", "finished": true, "optimum": 1, "search_steps": 2, "speed_steps": 1,
    "discovered": 0.75, "visited": 0.5, "last_words": "", "counts": [], "checked": "", "ended": true,
    "clock": [0, 1, 2, 3], "x": [1, 1, 1, 1], "y": [1, 3, 1, 3], "heading": [0, 0, 0, 0], "run": [0, 0, 1, 1],
    "action": ["ahead 1", "reset", "ahead 1"], "blocked": [false, false, false],
    "left": [0, 0, 0], "ahead": [1, 0, 1], "right": [1, 0, 1],
    "known": [0, -1, 0, 0,  0, 0, 1, 0], "goal_frame": 1, "reset_frame": 2, "entered": [[2], [], [2]],
    "route": [[0, 0], [0, 1]], "distances": [1, 2, 0, 3], "reasons": [], "events": [], "loses": [0, 0, 0],
    "traits": {"clock": "steps", "unit": "", "digits": 3, "runs": ["search", "speed run"], "draws": false,
               "pictured": true}
  })");
  expected["maze"] = data_of(test::hook());
  expected["score"] = expected["bound"] = 1 + 2 / 30.0;
  expected["scores"] = {0.0, 1 / 30.0, 2 / 30.0, 1 + 2 / 30.0};
  EXPECT_EQ(play, expected);
}

TEST(PagePlay, NamesActions) {
  EXPECT_EQ(short_words(Action::step(0, 2)), "ahead 2");
  EXPECT_EQ(short_words(Action::step(0, -2)), "back 2");
  EXPECT_EQ(short_words(Action::step(90, 3)), "right, 3");
  EXPECT_EQ(short_words(Action::step(-90, -1)), "left, back 1");
  EXPECT_EQ(short_words(Action::step(90, 0)), "right");
  EXPECT_EQ(short_words(Action::step(45, 1)), "turn 45, 1");
  EXPECT_EQ(short_words(Action::step(0, 0)), "stay");
  EXPECT_EQ(short_words(Action::reset()), "reset");
  EXPECT_EQ(short_words(Action::forfeit(ForfeitReason::lost)), "forfeit: lost");
}

/// The same cells as in the heat of a picture, but for the start, in which it stands from the beginning.
TEST(PagePlay, EntersTheCellsOfTheHeat) {
  const RecordFile file = recorded("flood");
  const json play = play_of("flood");
  json way = json::array(), heat = json::array();
  for (std::size_t i = 0; i < play["entered"].size(); ++i)
    for (const json& cell : play["entered"][i])
      if (play["run"][i] == 0) way.push_back(cell);
  for (const Cell cell : explored_way(file.run, file.maze->size())) heat.push_back(file.maze->size().index(cell));
  heat.erase(0);
  EXPECT_EQ(way, heat);
}

TEST(PagePlay, HasTheReasonsOfAMouseThatKeepsThem) {
  const RecordFile file = recorded("ariadne", test::loop(), 1, true);
  const json play = play_of("ariadne");
  ASSERT_EQ(play["reasons"].size(), file.run.reasons.size());
  const StepReasons& first = file.run.reasons.front();
  const json& choice = play["reasons"][0];
  EXPECT_EQ(choice["frame"], first.step - 1);
  EXPECT_EQ(choice["chosen"], first.reasons.chosen);
  EXPECT_EQ(choice["candidates"].size(), first.reasons.candidates.size());
  const Candidate& candidate = first.reasons.candidates.front();
  EXPECT_DOUBLE_EQ(choice["candidates"][0]["through"], candidate.through / 30.0);
  EXPECT_DOUBLE_EQ(choice["candidates"][0]["score"], candidate.score / 30.0);
  EXPECT_EQ(choice["candidates"][0]["travel"], candidate.travel);
  EXPECT_EQ(choice["candidates"][0]["wall"][2], name_of(candidate.wall.side));
  EXPECT_THAT(choice["ground"].get<std::string>(), HasSubstr("lowest score"));
}

TEST(PagePlay, SaysWhyAMouseGaveUp) {
  const json play = play_of("flood", test::without_route());
  EXPECT_EQ(play["outcome"], "forfeit: no route");
  EXPECT_EQ(play["finished"], false);
  for (const char* field : {"score", "bound", "optimum", "goal_frame", "reset_frame"})
    EXPECT_TRUE(play[field].is_null()) << field;
  EXPECT_EQ(play["action"].back(), "forfeit: no route");
}

TEST(PagePlay, ComesWithItsRecord) {
  const json said = answer("contest", running("ariadne"));
  EXPECT_EQ(said["record"], write_record(recorded("ariadne", test::loop(), 1, true)));
}

TEST(PagePlay, TakesABudget) {
  json request = running("flood");
  request["budget"] = 3;
  EXPECT_EQ(answer("contest", request)["play"]["outcome"], "out of steps");
  request["budget"] = 1000001;
  EXPECT_THAT(error_of("contest", request), Says("'budget'", "1 to 1000000"));
}

TEST(PagePlay, IsOfOneBuiltinMouse) {
  EXPECT_THAT(error_of("contest", running("flod")), Says("'flod'", "'flood'", "`labmouse mice`"));
  EXPECT_THAT(error_of("contest", running("flood,certify")), Says("'flood,certify'", "several"));
  EXPECT_THAT(error_of("contest", running("program:ls")), Says("'program:ls'", "program", "`labmouse race`"));
  EXPECT_THAT(error_of("contest", running("flood,mms:ls")), Says("'mms:ls'", "program"));
  EXPECT_THAT(error_of("contest", running("capstone:r.py")), Says("'capstone:r.py'", "program"));
  EXPECT_THAT(error_of("contest", running("festina")), Says("'festina'", "steps"));
  EXPECT_THAT(error_of("contest", running("ariadne:cell_most=1")), Says("'cell_most'", "steps"));
}

TEST(PagePlay, HasNoPriorsOfFiles) {
  const std::string error = error_of("contest", running("ariadne:prior=my.prior"));
  EXPECT_THAT(error, Says("'my.prior'", "'ariadne'", "file", "contest"));
  EXPECT_THAT(error_of("contest", running("flood,ariadne:prior=")), HasSubstr("is a file"));
  EXPECT_THAT(error_of("contest", running("ariadne:")), Says("'ariadne'", "key=value"));
}

}  // namespace
}  // namespace labmouse
