// The calls of the page as a whole: their names, what the core brings, and requests that are none.
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "labmouse/lab/bench/signature.hpp"
#include "labmouse/lab/mice/mice_json.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/worlds/entering.hpp"
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

std::string source(const std::string& path) {
  std::ifstream file(std::string(LABMOUSE_SOURCE_DIR) + "/" + path);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::set<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at) found.insert((*at)[1]);
  return found;
}

std::set<std::string> call_names() { return {page_calls().begin(), page_calls().end()}; }

TEST(PageCalls, AreListedForThePage) {
  std::string types = source("apps/web/page/src/core/types.ts");
  types = types.substr(types.find("export interface Calls {"));
  types = types.substr(0, types.find("\n}\n"));
  EXPECT_EQ(matches(types, R"(\n  (\w+): \{)"), call_names());
}

TEST(PageCalls, RefuseWhatIsNoRequest) {
  const auto error = [](std::string_view call, std::string_view request) -> std::string {
    return json::parse(answer_page(call, request, "").json)["failure"]["error"];
  };
  EXPECT_THAT(error("fly", "{}"), Says("no call", "'fly'"));
  for (const char* bad : {"", "{", "[]", "3", "null", "{\"maze\":\"\xff\"}"})
    EXPECT_THAT(error("inspect", bad), Says("request", "JSON object")) << bad;
}

/// Whatever stands in a field, there is an answer or a failure in words.
TEST(PageCalls, SurviveAnythingInAnyField) {
  const json maze = data_of(test::hook());
  const json requests = {{"maze", maze},
                         {"mouse", "flood"},
                         {"seed", 1},
                         {"name", "a"},
                         {"generator", "prim"},
                         {"width", 4},
                         {"height", 4},
                         {"loops", 0},
                         {"mice", {"flood", "certify"}},
                         {"begin", 0},
                         {"most", 4},
                         {"better_by", 0.02},
                         {"alpha", 0.05},
                         {"beta", 0.05},
                         {"shares", {{0.5, nullptr}}},
                         {"runs", 1},
                         {"mazes", {maze}},
                         {"differences", {1.5}},
                         {"contests", json::array({json{{"mouse", "flood"}, {"seed", 1}}})},
                         {"format", "maz"},
                         {"link", "x"},
                         {"frames", 2},
                         {"known", {0, 0, 0, 0, 0, 0, 0, 0}},
                         {"stride", 3},
                         {"record", json::object()}};
  const json anything = {nullptr,           true,         -1, 0, 1e300, "", "x", json::array(), json::object(),
                         {1, "a", nullptr}, {{"name", 1}}};
  int asked = 0;  // with the sanitizers every third is asked
  for (const std::string_view call : page_calls()) {
    if (call == "about" || call == "signature" || call == "speed") continue;
    for (const auto& [field, value] : requests.items())
      for (const json& bad : anything) {
        if (test::briefly_sanitized && ++asked % 3 != 0) continue;
        json request = requests;
        request[field] = bad;
        const json said = test::said(call, request, "no file");
        EXPECT_TRUE(said.contains("answer") || !said["failure"]["error"].get<std::string>().empty())
            << call << field << bad;
      }
    for (const auto& [field, value] : maze.items())
      for (const json& bad : anything) {
        json request = requests;
        request["maze"][field] = bad;
        const json said = test::said(call, request, "no file");
        EXPECT_TRUE(said.contains("answer") || !said["failure"]["error"].get<std::string>().empty())
            << call << field << bad;
      }
  }
}

TEST(PageCalls, TellWhatTheCoreBrings) {
  const json about = answer("about", json::object());
  const json mice = json::parse(mice_json().dump());
  ASSERT_EQ(about["mice"].size(), mice.size());
  std::set<std::string> types;
  std::map<std::string, std::string> counts_in;
  for (std::size_t i = 0; i < mice.size(); ++i) {
    EXPECT_EQ(about["mice"][i]["name"], mice[i]["name"]);
    EXPECT_EQ(about["mice"][i]["parameters"].size(), mice[i]["parameters"].size());
    for (const json& parameter : about["mice"][i]["parameters"]) {
      types.insert(parameter["type"]);
      if (mice[i]["name"] == "ariadne" || mice[i]["name"] == "festina")
        counts_in[parameter["name"]] = parameter.value("counts_in", "both");
    }
  }
  EXPECT_EQ(counts_in["prior"], "both");
  EXPECT_EQ(counts_in["travel"], "steps");
  EXPECT_EQ(counts_in["cell_most"], "seconds");
  EXPECT_EQ(counts_in["slower"], "errors");
  EXPECT_EQ(counts_in["strategy"], "both");
  EXPECT_EQ(types, (std::set<std::string>{"whole", "real", "flag", "choice", "list", "prior"}));
  EXPECT_GE(about["mazes"].size(), 5U);
  EXPECT_THAT(about["mazes"], ::testing::Contains(json{{"name", "capstone-1"}, {"width", 12}, {"height", 12}}));
  // A choice takes one value: the text of a robot file has commas itself.
  for (const json& world : about["worlds"])
    for (const json& setting : world["settings"])
      EXPECT_FALSE(setting["type"] == "choice" && setting.contains("listed")) << world["name"] << setting["name"];
  EXPECT_EQ(about["formats"].size(), 11U);
  EXPECT_EQ(about["generators"].size(), 7U);
  EXPECT_EQ(about["rules"], json::parse(R"({"budget":1000,"search_factor":30,"stride":3,"failure_score":100.0})"));
  EXPECT_EQ(about["most_side"], 64);
  for (const char* field : {"version", "compiler"}) EXPECT_FALSE(about[field].get<std::string>().empty());
}

TEST(PageCalls, HaveTheSignature) {
  if (test::sanitized) GTEST_SKIP() << "the mice that walk in it have their own tests there";
  EXPECT_EQ(answer("signature", json::object())["signature"], signature());
}

json race(const json& more = json::object()) {
  json request = {{"mice", {"flood", "random"}},
                  {"mazes", {data_of(test::loop()), data_of(test::corridor())}},
                  {"seed", 3},
                  {"runs", 2}};
  request.update(more);
  return request;
}

/// Results without what differs from race to race.
json timeless(json results) {
  for (json& mouse : results["groups"][0]["mice"]) {
    mouse.erase("microseconds_per_decision");
    for (json& result : mouse["results"]) result.erase("microseconds_per_decision");
  }
  return results;
}

TEST(PageCalls, HoldARaceAsTheLabDoes) {
  RaceOrder order = test::in_steps();
  order.seed = 3;
  order.runs = 2;
  const Race held = hold_race(test::mice("flood,random"), {test::loop(), test::corridor()}, order);
  EXPECT_EQ(timeless(answer("race", race())["results"]), timeless(json::parse(json_of(held, {}))));
}

TEST(PageCalls, RaceTheBuiltinMiceWhereNoMouseIsNamed) {
  const json results = answer("race", race({{"mice", json::array()}, {"runs", 1}}))["results"];
  EXPECT_EQ(results["groups"][0]["mice"].size(), residents_of(*first_world()).size());
}

TEST(PageCalls, RefuseRacesThatCannotBe) {
  EXPECT_THAT(error_of("race", race({{"mazes", json::array()}})), Says("at least one maze"));
  EXPECT_THAT(error_of("race", race({{"mazes", {data_of(test::loop()), data_of(test::loop())}}})),
              Says("two mazes", "'loop'"));
  EXPECT_THAT(error_of("race", race({{"mazes", {data_of(test::loop()), 3}}})), Says("'mazes[1]'", "object"));
  EXPECT_THAT(error_of("race", race({{"mice", {"flood", 3}}})), Says("'mice'", "string"));
  EXPECT_THAT(error_of("race", race({{"runs", 0}})), Says("'runs'", "1 to 1000"));
  for (const char* external : {"program:ls", "flood,a=program:ls"})
    EXPECT_THAT(error_of("race", race({{"mice", {external}}})), Says("'program:ls'", "program"));
  EXPECT_THAT(error_of("race", race({{"mice", {"mice-file:mice.toml"}}})), Says("'mice-file:mice.toml'", "file"));
  json many = json::array();
  for (int i = 0; i < 21; ++i) many.push_back(data_of({std::to_string(i), test::hook().maze}));
  EXPECT_THAT(error_of("race", race({{"mice", {"random"}}, {"mazes", many}, {"runs", 1000}})),
              Says("21000 contests", "too many"));
}

}  // namespace
}  // namespace labmouse
