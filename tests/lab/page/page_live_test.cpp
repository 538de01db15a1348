// The map of a real robot through the calls of the page.
#include <gmock/gmock.h>

#include <cstdint>
#include <string>
#include <vector>

#include "labmouse/lab/live/live_plan.hpp"
#include "labmouse/lab/live/live_reader.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::answer;
using test::data_of;
using test::error_of;
using test::json;
using test::Says;

/// The same stream, read without the page.
struct Plain {
  explicit Plain(LiveMap begin) : map(std::move(begin)), reader(map.map().known.size()) {}

  std::vector<std::string> feed(std::string_view bytes) {
    std::vector<std::string> words;
    for (const LiveLine& line : reader.feed(bytes))
      for (const LiveFinding& finding : map.add(line)) words.push_back(words_of(finding));
    return words;
  }

  LiveMap map;
  LiveReader reader;
};

std::vector<std::string> words_in(const json& findings) {
  std::vector<std::string> words;
  for (const json& finding : findings) words.push_back(finding["words"]);
  return words;
}

const std::string sent =
    "start\n0 0 N 101 batt=7900\nnoise!\n0 1 N 110 v=250.5 route=EN\n1 1 E 011 v=x\n0 1 N 0?1 v=100 batt=7850\n";

TEST(PageLive, GivesTheMapOfTheCommandLineInAnyPieces) {
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, sent.size()}) {
    Plain plain{LiveMap(Size{3, 3})};
    const std::vector<std::string> expected = plain.feed(sent);
    const json begun = answer("live_begin", {{"width", 3}, {"height", 3}});
    std::vector<std::string> found;
    json values = json::array(), now;
    for (std::size_t at = 0; at < sent.size(); at += piece) {
      now = answer("live_feed", {{"stream", begun["stream"]}}, sent.substr(at, piece));
      for (const std::string& words : words_in(now["findings"])) found.push_back(words);
      for (const json& value : now["values"]) values.push_back(value);
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(now["drawing"], *write_partial_map(plain.map.map()).content);
    EXPECT_EQ(now["lines"], plain.reader.lines());
    EXPECT_EQ(now["noise"], plain.reader.noise());
    EXPECT_EQ(now["restarts"], 1);
    EXPECT_EQ(now["pose"], json::parse(R"({"cell":[0,1],"heading":"north"})"));
    EXPECT_EQ(now["contradictions"].size(), plain.map.contradictions().size());
    EXPECT_GT(now["contradictions"].size(), 0U);
    EXPECT_EQ(values, json::parse(R"([{"line":2,"v":null,"batt":7900.0},{"line":4,"v":250.5,"batt":null},
                                      {"line":6,"v":100.0,"batt":7850.0}])"));
    EXPECT_EQ(now["fields"]["batt"], "7850");
    EXPECT_EQ(now["advice"], "");
    answer("live_end", {{"stream", begun["stream"]}});
  }
}

TEST(PageLive, HasTheRouteOfTheRobotAndItsUnseenWalls) {
  const json begun = answer("live_begin", {{"width", 2}, {"height", 2}});
  EXPECT_EQ(begun["unseen"], json({3, 1, 2, 0}));
  const json now = answer("live_feed", {{"stream", begun["stream"]}}, "0 0 N ?01 route=NE\n");
  EXPECT_EQ(now["route"], json::parse("[[0,0],[0,1],[1,1]]"));
  EXPECT_EQ(now["unseen"], json({0, 1, 2, 0}));
}

TEST(PageLive, MarksFalseAndMissedWallsOfAKnownMaze) {
  const NamedMaze maze = test::corridor();
  const bool is_open = maze.maze.is_open(Cell{0, 0}, Heading::north);
  const json begun = answer("live_begin", {{"maze", data_of(maze)}});
  const json wrong = answer("live_feed", {{"stream", begun["stream"]}}, is_open ? "0 0 N ?1?\n" : "0 0 N ?0?\n");
  ASSERT_EQ(wrong["wrong"].size(), 1U);
  EXPECT_EQ(wrong["wrong"][0]["kind"], is_open ? "false_wall" : "missed_wall");
  EXPECT_EQ(wrong["wrong"][0]["cell"], json({0, 0}));
  EXPECT_EQ(wrong["wrong"][0]["side"], "north");
  EXPECT_EQ(wrong["wrong"][0]["line"], 1);
  // The newest reading counts.
  const json right = answer("live_feed", {{"stream", begun["stream"]}}, is_open ? "0 0 N ?0?\n" : "0 0 N ?1?\n");
  EXPECT_EQ(right["wrong"], json::array());
  EXPECT_EQ(right["contradictions"].size(), 1U);
}

TEST(PageLive, AdvisesAsTheCommandLine) {
  const DriveModel model = find_robot("classic").model;
  const LivePlanner planner(model);
  const std::string seen = "0 0 N 101\n0 1 N 10?\n0 2 E 100\n1 2 S 10?\n";
  Plain plain{LiveMap(Size{3, 3})};
  plain.feed(seen);
  const LivePlan plan = planner.plan(plain.map.map());
  const json begun = answer("live_begin", {{"width", 3}, {"height", 3}, {"robot", "classic"}, {"built_in", "classic"}});
  EXPECT_EQ(begun["plan"], "");
  const json now = answer("live_feed", {{"stream", begun["stream"]}}, seen);
  EXPECT_EQ(now["advice"], planner.text_of(plan));
  EXPECT_EQ(now["plan"], planner.line_of(plan));
  EXPECT_NE(now["plan"], "");
}

/// 200 lines a second.
TEST(PageLive, KeepsAsMuchAfterManyMinutesAsAfterOne) {  // an hour with LABMOUSE_PROOF
  const json begun = answer("live_begin", {{"width", 3}, {"height", 3}});
  std::string second;
  for (int i = 0; i < 49; ++i) second += "0 0 N 101 v=1\n0 1 N 110 batt=7900\n0 1 N 1?0 x=1\n@#!\n";
  second += "0 0 N 101 v=1\n0 1 N 110 batt=7900\n0 1 N 1?1 x=1\n@#!\n";
  const auto size_after = [&](int seconds) {
    PageAnswer now;
    for (int i = 0; i < seconds; ++i) now = answer_page("live_feed", json{{"stream", begun["stream"]}}.dump(), second);
    json state = json::parse(now.json)["answer"];
    // Their numbers of lines have more digits.
    EXPECT_EQ(state["findings"].size(), 2U);
    EXPECT_EQ(state["contradictions"].size(), 1U);
    EXPECT_EQ(state["values"].size(), 100U);
    for (const char* one : {"findings", "contradictions", "values", "lines", "noise"}) state.erase(one);
    return state.dump().size();
  };
  const int minutes = test::thorough ? 60 : 5;
  const std::size_t begin = size_after(60);
  EXPECT_EQ(size_after(60 * (minutes - 1)), begin);
  const json end = answer("live_feed", {{"stream", begun["stream"]}}, "");
  EXPECT_EQ(end["lines"], 12'000 * minutes);
  EXPECT_EQ(end["noise"], 3'000 * minutes);
}

TEST(PageLive, RefusesWhatItCannotRead) {
  EXPECT_NE(error_of("live_begin", {{"width", 3}}), "");
  EXPECT_NE(error_of("live_begin", {{"width", 0}, {"height", 3}}), "");
  EXPECT_NE(error_of("live_begin", {{"width", 3}, {"height", 3}, {"robot", "x"}}, "no = 1"), "");
  EXPECT_NE(error_of("live_feed", {{"stream", 1'000'000}}), "");
  const json begun = answer("live_begin", {{"width", 3}, {"height", 3}});
  answer("live_end", {{"stream", begun["stream"]}});
  EXPECT_THAT(error_of("live_feed", {{"stream", begun["stream"]}}, "0 0 N 101\n"), Says("stream"));
}

}  // namespace
}  // namespace labmouse
