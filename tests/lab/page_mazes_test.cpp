// Mazes in the calls of the page: those that it gives, and those that it takes.
#include <gmock/gmock.h>

#include "labmouse/lab/mazes/builtin_mazes.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/lab/page_fixture.hpp"

namespace labmouse {
namespace {

using test::answer;
using test::data_of;
using test::error_of;
using test::hook;
using test::json;
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
  EXPECT_EQ(error_of("inspect", inspecting("walls/0", 13)),
            "'maze' has cell (0,1) open to the south, where its neighbour is closed");
  EXPECT_EQ(error_of("inspect", inspecting("walls/0", 8)),
            "'maze' has cell (0,0) open to the south, where the border is");
  EXPECT_EQ(error_of("inspect", inspecting("walls", json::array({1, 2, 3}))),
            "'maze' has walls of 3 cells where 2x2 are due");
}

TEST(PageMazes, WithWrongFieldsAreRefused) {
  EXPECT_EQ(error_of("inspect", json::object()), "'maze' is missing");
  EXPECT_EQ(error_of("inspect", json{{"maze", 3}}), "'maze' is not an object");
  EXPECT_EQ(error_of("inspect", inspecting("width", 65)), "'maze.width' is outside of 1 to 64");
  EXPECT_EQ(error_of("inspect", inspecting("height", "2")), "'maze.height' is not a whole number");
  EXPECT_EQ(error_of("inspect", inspecting("walls", "open")), "'maze.walls' is not a list");
  EXPECT_EQ(error_of("inspect", inspecting("walls/2", 16)), "'maze.walls' is outside of 0 to 15");
  EXPECT_EQ(error_of("inspect", inspecting("start", json::array({2, 0}))), "'maze' has its start outside");
  EXPECT_EQ(error_of("inspect", inspecting("heading", "up")), "'maze.heading' is not one of north, east, south, west");
  EXPECT_EQ(error_of("inspect", inspecting("goals", json::array())), "'maze' has no goal");
  EXPECT_EQ(error_of("inspect", inspecting("goals", json::array({json::array({0, 2})}))), "'maze' has a goal outside");
  EXPECT_EQ(error_of("inspect", inspecting("name", nullptr)), "'maze.name' is not a text");
}

TEST(PageMazes, BuiltIn) {
  for (const BuiltinMaze& builtin : builtin_mazes()) {
    const json maze = answer("builtin_maze", {{"name", builtin.name}})["maze"];
    EXPECT_EQ(maze, data_of({std::string(builtin.name), *read_maze(builtin.text).maze}));
  }
  EXPECT_EQ(error_of("builtin_maze", {{"name", "capstone-9"}}), "there is no built-in maze 'capstone-9'");
  EXPECT_EQ(error_of("builtin_maze", {{"name", 3}}), "'name' is not a text");
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
  EXPECT_EQ(error_of("make_maze", order({{"generator", "magic"}})), "there is no generator 'magic'");
  EXPECT_EQ(error_of("make_maze", order({{"width", 0}})), "'width' is outside of 1 to 64");
  EXPECT_EQ(error_of("make_maze", order({{"loops", 1.5}})), "'loops' is outside of 0 to 1");
  EXPECT_EQ(error_of("make_maze", order({{"seed", -1}})), "'seed' is not a number from 0 to 2^64 - 1");
  EXPECT_EQ(error_of("make_maze", order({{"seed", 1e21}})), "'seed' is not a number from 0 to 2^64 - 1");
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
