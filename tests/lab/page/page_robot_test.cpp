// A robot as the page edits it, and what follows from it, beside what the command line says.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <deque>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "labmouse/lab/mazes/builtin_mazes.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/hardware_keys.hpp"
#include "labmouse/lab/robots/robot_family.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/robot_keys.hpp"
#include "labmouse/lab/robots/robot_table.hpp"
#include "labmouse/lab/routes/region_picture.hpp"
#include "labmouse/lab/routes/route_regions.hpp"
#include "labmouse/lab/routes/route_report.hpp"
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
using ::testing::HasSubstr;

NamedMaze maze_named(std::string_view name) {
  for (const BuiltinMaze& maze : builtin_mazes())
    if (maze.name == name) return {std::string(name), *read_maze(maze.text).maze};
  throw std::runtime_error("no such maze");
}

json built_in(std::string_view robot) { return answer("robot", {{"name", robot}, {"built_in", robot}}); }

json changed(std::string_view robot, const std::string& key, const json& value) {
  json values = built_in(robot)["values"];
  values[key] = value;
  return answer("robot", {{"name", robot}, {"values", values}});
}

/// The problem of the robot with that change; it must be one.
json problem(std::string_view robot, const std::string& key, const json& value) {
  const json said = changed(robot, key, value);
  EXPECT_EQ(said["result"], nullptr);
  EXPECT_EQ(said["problems"].size(), 1U) << said["problems"].dump();
  return said["problems"].empty() ? json({{"key", ""}, {"text", ""}}) : said["problems"][0];
}

std::string ms(const json& value) { return fmt::format("{} ms", value.get<double>()); }

TEST(PageRobot, HasTheNumbersOfRobotShow) {
  for (const BuiltinRobot& builtin : builtin_robots()) {
    SCOPED_TRACE(builtin.name);
    const FoundRobot found = find_robot(std::string(builtin.name));
    const std::string table = robot_table(found.robot, found.model);
    const json result = built_in(builtin.name)["result"];
    std::size_t lines = 0;
    for (const json& turn : result["turns"]) {
      bool first = true;
      for (const json& speed : turn["speeds"]) {
        std::string line = fmt::format("\n{:<5} {:>7.1f} {:>8.3f}", first ? turn["turn"].get<std::string>() : "",
                                       speed["speed"].get<double>(), speed["ms"].get<double>());
        if (!turn["length"].is_null())
          line += fmt::format(" {:>8.1f} {:>8.1f} {:>8.1f} {:>9.1f}\n", turn["lead_in"].get<double>(),
                              turn["lead_out"].get<double>(), turn["length"].get<double>(),
                              turn["clearance"].get<double>());
        EXPECT_THAT(table, HasSubstr(line));
        first = false;
        ++lines;
      }
    }
    EXPECT_EQ(lines, shown_turns(found.model).size());
    const json& search = result["search"];
    EXPECT_THAT(table,
                HasSubstr(fmt::format("cell {}, turn {}, back {}, quarter on the spot {}, half a cell from rest {}",
                                      ms(search["cell"]), ms(search["turn"]), ms(search["back"]), ms(search["quarter"]),
                                      ms(search["half_cell"]))));
    EXPECT_THAT(table, HasSubstr(result["tables"].get<std::string>()));
  }
}

TEST(PageRobot, HasTheRouteOfTheCommandLine) {
  const NamedMaze maze = maze_named("contest-01");
  for (const char* name : {"classic", "mm2021"}) {
    const FoundRobot found = find_robot(name);
    json route = answer("robot", {{"name", name}, {"built_in", name}, {"maze", data_of(maze)}})["route"];
    const json path = route["path"];
    route.erase("path");
    const RouteReport report = route_report(maze.maze, found.model);
    EXPECT_EQ(route, json::parse(json_of({report}, {maze}, found.model))["mazes"][0]);
    EXPECT_EQ(path["t"].back(), route["time_us"]);
  }
  const json large = answer("robot", {{"name", "it"},
                                      {"built_in", "classic"},
                                      {"maze", data_of({"large", Maze(MazeDraft({33, 4}, MazeDraft::Inside::open))})}});
  EXPECT_THAT(large["no_route"].get<std::string>(), Says("33x4", "32x32"));
}

json range(const char* key, double from, double to) { return {{"key", key}, {"from", from}, {"to", to}}; }

json asked_regions(const NamedMaze& maze) {
  return {{"name", "classic"},
          {"built_in", "classic"},
          {"maze", data_of(maze)},
          {"vary", range("curve.lateral_acceleration", 4000, 16000)}};
}

TEST(PageRegions, AreThoseOfTheCommandLine) {
  LABMOUSE_SKIP_SANITIZED();
  const NamedMaze maze = maze_named("contest-01");
  const RobotFamily classic = *find_robot_family("classic").family;
  const auto expect_same = [&](const json& asked, const RegionOrder& order) {
    const json said = answer("regions", asked);
    const RouteRegions found = find_regions(maze.maze, classic, order);
    EXPECT_EQ(said["regions"], json::parse(json_of(found, order, maze.name, "classic")));
    EXPECT_EQ(said["svg"], draw_regions(maze.maze, found, order, "contest-01: which route wins, for which classic"));
  };
  json asked = asked_regions(maze);
  const VariedNumber grip = {"curve.lateral_acceleration", 4000, 16000};
  expect_same(asked, order_of(grip, std::nullopt));
  if (!test::thorough) return;
  asked["and"] = range("straight.acceleration", 4000, 5000);
  expect_same(asked, order_of(grip, VariedNumber{"straight.acceleration", 4000, 5000}));
}

TEST(PageRegions, HaveTheTimesOfTheBestRoutesAtTheirEnds) {
  LABMOUSE_SKIP_SANITIZED();
  const NamedMaze maze = maze_named("contest-01");
  const auto time_with = [&](double grip) {
    json values = built_in("classic")["values"];
    values["curve.lateral_acceleration"] = grip;
    return answer("robot", {{"name", "it"}, {"values", values}, {"maze", data_of(maze)}})["route"]["time_us"];
  };
  const json regions = answer("regions", asked_regions(maze))["regions"]["rows"][0]["regions"];
  ASSERT_EQ(regions.size(), 2U);
  for (const json& region : regions) {
    EXPECT_EQ(region["time_from_us"], time_with(region["from"]));
    EXPECT_EQ(region["time_to_us"], time_with(region["to"]));
  }
}

TEST(PageRegions, AreThoseOfARobotThatIsEdited) {
  LABMOUSE_SKIP_SANITIZED();
  json asked = asked_regions(maze_named("contest-01"));
  asked["vary"] = range("curve.lateral_acceleration", 4000, 4200);
  const json builtin = answer("regions", asked)["regions"];
  asked["values"] = built_in("classic")["values"];
  asked.erase("built_in");
  EXPECT_EQ(answer("regions", asked)["regions"], builtin);
  asked["values"]["straight.acceleration"] = 30000;
  EXPECT_NE(answer("regions", asked)["regions"], builtin);
}

TEST(PageRegions, TakeNoOtherRequests) {
  const json good = asked_regions(maze_named("contest-01"));
  const auto error_with = [&](const char* field, const json& value) {
    json asked = good;
    asked[field] = value;
    return error_of("regions", asked);
  };
  EXPECT_THAT(error_with("vary", range("wheels", 1, 2)), HasSubstr("'wheels'"));
  EXPECT_THAT(error_with("vary", range("curve.speeds", 1, 2)), HasSubstr("'curve.speeds'"));
  EXPECT_THAT(error_with("vary", range("clearance", 5, 5)), HasSubstr("'vary' needs a range"));
  EXPECT_THAT(error_with("and", range("clearance", 6, 5)), HasSubstr("'and' needs a range"));
  EXPECT_THAT(error_with("and", good["vary"]), HasSubstr("the same number"));
  EXPECT_THAT(error_with("vary", 5), HasSubstr("'vary'"));
  EXPECT_THAT(error_with("vary", range("clearance", 60000, 70000)), HasSubstr("no robot of this range"));
  json refused = good;
  refused.erase("built_in");
  refused["values"] = {{"cell", 180}};
  EXPECT_THAT(error_of("regions", refused), HasSubstr("refused"));
  json large = good;
  large["maze"] = data_of({"large", Maze(MazeDraft({33, 4}, MazeDraft::Inside::open))});
  EXPECT_THAT(error_of("regions", large), Says("33x4", "32x32"));
}

TEST(PageRobot, WritesWhatItReads) {
  for (const BuiltinRobot& builtin : builtin_robots()) {
    SCOPED_TRACE(builtin.name);
    const json read = built_in(builtin.name);
    EXPECT_EQ(read["text"], builtin.text);
    const json written = answer("robot", {{"name", builtin.name}, {"values", read["values"]}});
    EXPECT_EQ(written["result"], read["result"]);
    EXPECT_EQ(written["values"], read["values"]);
    // As a file.
    const json opened = answer("robot", {{"name", builtin.name}}, written["text"].get<std::string>());
    EXPECT_EQ(opened["result"], read["result"]);
  }
}

TEST(PageRobot, SaysWhatIsWrongAtItsField) {
  EXPECT_EQ(problem("classic", "cell", 5)["key"], "cell");
  EXPECT_EQ(problem("classic", "straight.braking", "hard")["key"], "straight.braking");
  EXPECT_EQ(problem("classic", "clearance", 70)["key"], "clearance");
  EXPECT_EQ(problem("classic", "search.speed", 1100)["key"], "search.speed");
  EXPECT_EQ(problem("mm2021", "clearance", 50)["key"], "clearance");
  json values = built_in("classic")["values"];
  values.erase("curve.yaw_acceleration");
  const json missing = answer("robot", {{"name", "it"}, {"values", values}});
  EXPECT_EQ(missing["problems"][0]["key"], "curve.yaw_acceleration");
  EXPECT_EQ(missing["values"], values);
}

TEST(PageRobot, RemarksAtTheFieldOfWhatIsLikelyAMistake) {
  EXPECT_EQ(built_in("classic")["remarks"], json::array());
  const json said = changed("classic", "curve.yaw_acceleration", 17000);
  ASSERT_EQ(said["remarks"].size(), 1U);
  EXPECT_EQ(said["remarks"][0]["key"], "curve.yaw_acceleration");
  EXPECT_THAT(said["remarks"][0]["text"].get<std::string>(), HasSubstr("degrees"));
}

TEST(PageRobot, TakesNoOtherRequests) {
  EXPECT_THAT(error_of("robot", {{"name", "it"}, {"built_in", "tank"}}), HasSubstr("'tank'"));
  EXPECT_THAT(error_of("robot", {{"name", "it"}, {"values", {{"wheels", 4}}}}), HasSubstr("'wheels'"));
  EXPECT_THAT(error_of("robot", {{"name", "it"}, {"values", {{"cell", json::array()}}}}), HasSubstr("'cell'"));
  EXPECT_THAT(error_of("robot", {{"name", "it"}, {"values", 1}}), HasSubstr("'values'"));
  // Names in the sensors of a list would be lines of the file.
  for (const json& sensors :
       {json::array({{{"gain = 1\n[body]\nmass", 2}}}), json::array({{{"gain", "1\nfall = 2"}}}),
        json::array({{{"period", 2}}}), json::array({1}), json::array({json::array()}), json(1), json::object()})
    EXPECT_THAT(error_of("robot", {{"name", "it"}, {"values", {{"infrared", sensors}}}}), HasSubstr("'infrared'"))
        << sensors;
  EXPECT_EQ(answer("robot", {{"name", "it"}}, "cell = [")["values"], json::object());
}

/// A robot of the user drives and races as a built-in one does, and drives again as results have it.
TEST(PageRobot, DrivesAndRacesWithATextBelowItsName) {
  const json maze = data_of(test::hook());
  const json classic = built_in("classic");
  const std::string mine = "mine\n" + classic["text"].get<std::string>();
  json request = {{"world", "seconds"}, {"mouse", "flood"},   {"maze", maze},
                  {"seed", 1},          {"robot", "classic"}, {"rules", "all-japan"}};
  const json theirs = answer("contest", request);
  request["robot"] = mine;
  const json driven = answer("contest", request);
  EXPECT_EQ(driven["play"]["score"], theirs["play"]["score"]);
  EXPECT_EQ(driven["play"]["drive"]["robot"]["name"], "mine");
  EXPECT_EQ(driven["play"]["drive"]["robot"]["hash"], theirs["play"]["drive"]["robot"]["hash"]);
  const json race = {{"mice", {"flood"}},  {"mazes", {maze}}, {"seed", 1},           {"runs", 1},
                     {"world", "seconds"}, {"robot", mine},   {"rules", "all-japan"}};
  const json group = answer("race", race)["results"]["groups"][0];
  EXPECT_EQ(group["robot"]["name"], "mine");
  EXPECT_EQ(group["mice"][0]["mean_score"], theirs["play"]["score"]);
  json again = {{"world", "seconds"}, {"mouse", "flood"}, {"maze", maze}, {"seed", 1}, {"conditions", group}};
  EXPECT_EQ(answer("contest", again)["record"], driven["record"]);
  request["robot"] = "mine\n" + changed("classic", "cell", 5)["text"].get<std::string>();
  EXPECT_THAT(error_of("contest", request), Says("mine", "'cell'", "20 to 1000 mm"));
  request["robot"] = 5;
  EXPECT_THAT(error_of("contest", request), HasSubstr("'robot'"));
}

/// One source: the tables of docs/reference/files.md say of each key what the page says beside its field.
TEST(RobotKeys, MeanWhatTheDocumentationSays) {
  std::ifstream file(std::filesystem::path(LABMOUSE_SOURCE_DIR) / "docs/reference/files.md");
  std::stringstream text;
  text << file.rdbuf();
  const std::string documentation = text.str();
  std::vector<RobotKey> keys(robot_keys().begin(), robot_keys().end());
  std::deque<std::string> names;
  const auto add = [&](std::string_view list, RobotKey key) {
    key.name = names.emplace_back(fmt::format("{}.{}", list, key.name));
    keys.push_back(key);
  };
  for (const auto& each : infrared_keys()) add(infrared_list, each.key);
  for (const auto& each : ranger_keys()) add(ranger_list, each.key);
  for (const RobotKey& key : keys) {
    const auto dot = key.name.find('.');
    const std::string name = dot == std::string_view::npos ? std::string(key.name) : std::string(key.name.substr(dot));
    bool found = false;
    std::istringstream lines(documentation);
    for (std::string line; std::getline(lines, line);) {
      const bool whole = line.starts_with(fmt::format("| `{}`", key.name));
      const bool listed = dot != std::string_view::npos &&
                          line.starts_with(fmt::format("| `{}.", key.name.substr(0, dot))) &&
                          line.find(fmt::format(", `{}`", name)) != std::string::npos;
      if (!whole && !listed) continue;
      std::erase(line, '`');
      found = found || (line.ends_with(fmt::format(" | {} |", key.meaning)) &&
                        line.find(fmt::format("| {}", key.unit)) != std::string::npos);
    }
    EXPECT_TRUE(found) << key.name << ": " << key.meaning;
  }
}

TEST(RobotKeys, AreFoundInSentences) {
  EXPECT_EQ(key_in("missing key 'straight.speed': 50 to 20000 mm/s"), "straight.speed");
  EXPECT_EQ(key_in("its search speed, 1100 mm/s, is above that of its turn S90"), "search.speed");
  EXPECT_EQ(key_in("change search.turn_speed, or the search speed"), "search.turn_speed");
  EXPECT_EQ(key_in("increase the lateral or yaw acceleration"), "curve.yaw_acceleration");
  EXPECT_EQ(key_in("its turn 90 fits into cells of 90 mm only up to 40 mm/s: increase the yaw acceleration"),
            "curve.yaw_acceleration");
  EXPECT_EQ(key_in("missing key 'cell': 20 to 1000 mm"), "cell");
  EXPECT_EQ(key_in("nothing of that kind"), "");
}

}  // namespace
}  // namespace labmouse
