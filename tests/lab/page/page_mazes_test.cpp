// Mazes in the calls of the page: those that it gives, and those that it takes.
#include <gmock/gmock.h>

#include "labmouse/lab/mazes/builtin_mazes.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::answer;
using test::data_of;
using test::error_of;
using test::hook;
using test::json;
using test::Says;
using test::with;
using ::testing::HasSubstr;

json inspecting(const json& maze) { return {{"maze", maze}}; }
json inspecting(const char* field, const json& value) {
  return with(inspecting(data_of(hook())), json::json_pointer("/maze/" + std::string(field)), value);
}

TEST(PageMazes, HaveTheClosedSidesOfEachCell) {
  EXPECT_EQ(data_of(hook()), json::parse(R"({"name":"hook","width":2,"height":2,"walls":[12,6,11,11],"start":[0,0],
                                             "heading":"north","goals":[[0,1]]})"));
}

TEST(PageMazes, AreReadAsTheyWereWritten) {
  const Maze maze = test::loop().maze.with_start({2, 1}, Heading::west).with_goals(CellSet::of({0, 4}));
  const MazeDataResult read = read_maze_data(data_of({"a maze", maze}), "maze");
  ASSERT_TRUE(read.maze) << read.error;
  EXPECT_EQ(read.maze->maze, maze);
  EXPECT_EQ(read.maze->name, "a maze");
}

TEST(PageMazes, ThatContradictThemselvesAreRefused) {
  EXPECT_THAT(error_of("inspect", inspecting("walls/0", 13)), Says("'maze'", "(0,1)", "south", "neighbour"));
  EXPECT_THAT(error_of("inspect", inspecting("walls/0", 8)), Says("'maze'", "(0,0)", "south", "border"));
  EXPECT_THAT(error_of("inspect", inspecting("walls", json::array({1, 2, 3}))), Says("'maze'", "3 cells", "2x2"));
}

TEST(PageMazes, WithWrongFieldsAreRefused) {
  EXPECT_THAT(error_of("inspect", json::object()), Says("'maze'", "missing"));
  EXPECT_THAT(error_of("inspect", json{{"maze", 3}}), Says("'maze'", "object"));
  EXPECT_THAT(error_of("inspect", inspecting("width", 65)), Says("'maze.width'", "1 to 64"));
  EXPECT_THAT(error_of("inspect", inspecting("height", "2")), Says("'maze.height'", "whole number"));
  EXPECT_THAT(error_of("inspect", inspecting("walls", "open")), Says("'maze.walls'", "list"));
  EXPECT_THAT(error_of("inspect", inspecting("walls/2", 16)), Says("'maze.walls'", "0 to 15"));
  EXPECT_THAT(error_of("inspect", inspecting("start", json::array({2, 0}))), Says("'maze'", "start", "outside"));
  EXPECT_THAT(error_of("inspect", inspecting("heading", "up")), Says("'maze.heading'", "north, east, south, west"));
  EXPECT_THAT(error_of("inspect", inspecting("goals", json::array())), Says("'maze'", "no goal"));
  EXPECT_THAT(error_of("inspect", inspecting("goals", json::array({json::array({0, 2})}))),
              Says("'maze'", "goal", "outside"));
  EXPECT_THAT(error_of("inspect", inspecting("name", nullptr)), Says("'maze.name'", "string"));
}

TEST(PageMazes, BuiltIn) {
  for (const BuiltinMaze& builtin : builtin_mazes()) {
    const json maze = answer("builtin_maze", {{"name", builtin.name}})["maze"];
    EXPECT_EQ(maze, data_of({std::string(builtin.name), *read_maze(builtin.text).maze}));
  }
  EXPECT_THAT(error_of("builtin_maze", {{"name", "capstone-9"}}), Says("built-in maze", "'capstone-9'"));
  EXPECT_THAT(error_of("builtin_maze", {{"name", 3}}), Says("'name'", "string"));
}

json order(const json& more = json::object()) {
  json request = {{"generator", "contest"}, {"width", 16}, {"height", 16}, {"seed", 7}, {"loops", 0.05}};
  request.update(more);
  return request;
}

TEST(PageMazes, Made) {
  const Maze maze = contest_generator.make({{16, 16}, 7, 50});
  EXPECT_EQ(answer("make_maze", order())["maze"], data_of({"contest-16x16-seed-7-loops-50", maze}));
  const std::string last = answer("make_maze", order({{"seed", 18446744073709551615U}, {"loops", 0}}))["maze"]["name"];
  EXPECT_EQ(last, "contest-16x16-seed-18446744073709551615");
}

TEST(PageMazes, ThatNoGeneratorMakesAreRefused) {
  EXPECT_THAT(error_of("make_maze", order({{"generator", "magic"}})), Says("unknown generator", "'magic'"));
  EXPECT_THAT(error_of("make_maze", order({{"width", 0}})), Says("'width'", "1 to 64"));
  EXPECT_THAT(error_of("make_maze", order({{"loops", 1.5}})), Says("'loops'", "0 to 1"));
  EXPECT_THAT(error_of("make_maze", order({{"seed", -1}})), Says("'seed'", "2^64 - 1"));
  EXPECT_THAT(error_of("make_maze", order({{"seed", 1e21}})), Says("'seed'", "2^64 - 1"));
  EXPECT_THAT(error_of("make_maze", order({{"width", 3}})), HasSubstr("contest"));
}

TEST(PageMazes, AreInspected) {
  const json found = answer("inspect", inspecting(data_of(test::corridor())));
  EXPECT_EQ(found["optimum"], 3);
  EXPECT_DOUBLE_EQ(found["bound"], 3 + 4 / 30.0);
  EXPECT_EQ(found["shortest_cells"], 7);
  EXPECT_EQ(found["shortest_runs"], 1);
  EXPECT_EQ(found["reachable"], 8);
  EXPECT_EQ(found["dead_ends"], 2);
  EXPECT_EQ(found["junctions"], 0);
  EXPECT_EQ(found["loops"], 0);
  EXPECT_EQ(found["left_follower_arrives"], true);
  EXPECT_EQ(found["contest_rules"].size(), 10U);
  EXPECT_EQ(found["contest_rules"][0]["name"], "size");
  EXPECT_EQ(found["contest_rules"][0]["passed"], false);
  EXPECT_EQ(found["distances"], json::parse("[0,1,1,1,3,3,3,2]"));
  EXPECT_EQ(found["route"], json::parse("[[0,1],[3,1],[3,0],[0,0]]"));
}

TEST(PageMazes, WithoutAWayHaveNoBounds) {
  const json found = answer("inspect", inspecting(data_of(test::without_route())));
  for (const char* field : {"optimum", "bound", "shortest_cells", "shortest_runs"})
    EXPECT_TRUE(found[field].is_null()) << field;
  EXPECT_EQ(found["route"], json::array());
  EXPECT_EQ(found["distances"], json::parse("[-1,0]"));
}

}  // namespace
}  // namespace labmouse
