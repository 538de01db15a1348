#include "labmouse/lab/reports/report_results.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "tests/lab/mms/mms_fixture.hpp"
#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::ProblemAt;
using test::Says;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Problem problem_of(const std::string& text) {
  const ReadResultsResult read = read_report_results(text);
  EXPECT_EQ(read.results.has_value(), !read.problem.has_value());
  return read.problem.value_or(Problem());
}

TEST(ReportResults, KnowWhoRanWhereWithWhichSeeds) {
  RaceOrder order = test::in_steps();
  order.runs = 3;
  const Race race = test::race_of("flood,random", order);
  const ReadResultsResult read = read_report_results(json_of(race, {}));
  ASSERT_TRUE(read.results);
  ASSERT_EQ(read.results->worlds.size(), 1U);
  const ReportWorld& world = read.results->worlds.front();
  EXPECT_EQ(world.entry->name, steps_world()->traits().name);
  ASSERT_EQ(world.mice.size(), 2U);
  EXPECT_EQ(world.mice[0].name, "flood");
  EXPECT_EQ(world.mice[0].seeds.at("loop").size(), 1U);
  EXPECT_EQ(world.mice[1].seeds.at("loop"),
            (std::set{contest_seed(1, "loop", 0), contest_seed(1, "loop", 1), contest_seed(1, "loop", 2)}));
  ASSERT_EQ(world.mazes.size(), 3U);
  EXPECT_EQ(world.mazes[1].name, "loop");
  EXPECT_EQ(world.mazes[1].size, test::loop().maze.size());
  EXPECT_EQ(world.mazes[1].optimum, bound_of(test::loop().maze, Rules()).optimum);
  EXPECT_EQ(world.mazes[2].optimum, std::nullopt);
}

TEST(ReportResults, StayAsTheyAre) {
  const std::string text = json_of(test::race_of("flood,certify"), {{"no-maze.txt", {{1, 2, "is none"}}}});
  EXPECT_EQ(text_of(nlohmann::ordered_json::parse(read_report_results(text).results->json)), text);
  EXPECT_TRUE(read_report_results("\xEF\xBB\xBF" + text).results);
}

TEST(ReportResults, KnowTheWorldOfMms) {
  Race mms = test::imagined_race({"left", "right"}, {test::plank()});
  test::imagine(mms, 1, 0, test::imagined_run(3, 1, 3, 1));
  const std::vector<Race> races = {test::race_of("flood"), std::move(mms)};
  const ReadResultsResult read = read_report_results(json_of(races, {}));
  ASSERT_TRUE(read.results);
  ASSERT_EQ(read.results->worlds.size(), 2U);
  const ReportWorld& world = read.results->worlds[1];
  EXPECT_EQ(world.entry->name, "mms");
  ASSERT_EQ(world.mice.size(), 2U);
  const ReportMouse& right = world.mice[world.mice[0].name == "mms:right" ? 0 : 1];
  EXPECT_TRUE(right.seeds.contains("plank"));
  EXPECT_EQ(world.mazes.front().size, (Size{3, 1}));
}

TEST(ReportResults, ThatAreNoJsonSayFromWhere) {
  EXPECT_THAT(problem_of(""), ProblemAt(1, 1, "JSON"));
  EXPECT_THAT(problem_of("{\n \"labmouse\": \"0.1\",\n \"mice\": oops\n}"), ProblemAt(3, 10, "JSON"));
  const std::string text = json_of(test::race_of("flood"), {});
  const Problem cut = problem_of(text.substr(0, text.size() / 2));
  EXPECT_GT(cut.line, 10);
  EXPECT_THAT(cut.reason, HasSubstr("not valid JSON"));
  EXPECT_EQ(problem_of("{\"labmouse\": \"\xFF\"}").line, 1);
}

TEST(ReportResults, ThatAreSomethingElseSayWhat) {
  EXPECT_THAT(problem_of(write_record(test::recorded("flood"))).reason, Says("record of one contest", "--record"));
  for (const char* kind : {"mms record", "drive record"})
    EXPECT_THAT(problem_of(fmt::format("{{\"labmouse\":\"{}\",\"format\":1}}\n{{}}\n", kind)).reason,
                Says("record of one contest", "--record"));
  EXPECT_THAT(problem_of(csv_of(test::race_of("flood"))).reason, Says("CSV of a race", "--format json"));
  EXPECT_THAT(problem_of(*drawing_format.write(test::corridor().maze).content).reason,
              Says("is a maze", "`labmouse show`"));
  EXPECT_THAT(problem_of("<!doctype html>\n<title>labmouse</title>").reason, HasSubstr("a page"));
}

TEST(ReportResults, ThatLackAFieldSayWhich) {
  const auto wrong = [](const std::string& text) { return problem_of(text).reason; };
  EXPECT_THAT(wrong("[]"), Says("JSON of a race", "'labmouse'", "missing", "--format json"));
  EXPECT_THAT(wrong("7"), Says("'labmouse'", "missing"));
  EXPECT_THAT(wrong(R"({"labmouse":7})"), Says("'labmouse'", "string"));
  EXPECT_THAT(wrong(R"({"labmouse":"1"})"), Says("'groups'", "missing"));
  EXPECT_THAT(wrong(R"({"labmouse":"1","mice":[1]})"), Says("'groups[0].mazes'", "missing"));
  EXPECT_THAT(wrong(R"({"labmouse":"1","mice":[],"groups":3})"), Says("'groups'", "list"));
  EXPECT_THAT(wrong(R"({"labmouse":"1","mazes":[{"name":"a","width":"3"}],"mice":[1]})"),
              Says("'groups[0].mazes[0].width'", "whole number"));
  EXPECT_THAT(wrong(R"({"labmouse":"1","mazes":[],"mice":{}})"), Says("'groups[0].mice'", "list"));
  EXPECT_THAT(wrong(R"({"labmouse":"1","mazes":[],"mice":[7]})"), Says("'groups[0].mice[0].name'", "missing"));
  EXPECT_THAT(wrong(R"({"labmouse":"1","mazes":[],"mice":[{"name":"a","results":[{"maze":"b","seed":-1}]}]})"),
              Says("'groups[0].mice[0].results[0].seed'", "whole number"));
  EXPECT_THAT(wrong(R"({"labmouse":"1","mazes":[],"mice":[],"groups":[{}]})"), Says("'groups[0].world'", "missing"));
  EXPECT_THAT(wrong(R"({"labmouse":"1","mazes":[],"mice":[],"groups":[{"world":"seconds"}]})"),
              Says("'groups[0].mazes'", "missing"));
  EXPECT_THAT(wrong(R"({"labmouse":"1","mazes":[],"mice":[],"groups":[{"world":"moon","mazes":[],"mice":[]}]})"),
              Says("'groups[0].world'", "world", "version"));
  EXPECT_EQ(wrong(R"({"labmouse":"1","mazes":[],"mice":[],"groups":[]})"), "");
}

TEST(ReportResults, WithANumberThatADoubleCannotHoldSayWhere) {
  const Problem problem = problem_of("{\n \"labmouse\": \"1\",\n \"mazes\": [{\"bound\": 1e309}],\n \"mice\": []\n}\n");
  EXPECT_EQ(problem.line, 3);
  EXPECT_EQ(problem.column, 22);
  EXPECT_THAT(problem.reason, Says("'1e309'", "large"));
}

TEST(ReportResults, OfDeepJsonAreRefused) {
  const auto deep = [](const std::string& open, int depth) {
    std::string text = R"({"labmouse":"1","mazes":[],"mice":[],"more":)";
    for (int i = 0; i < depth; ++i) text += open;
    text += "7";
    for (int i = 0; i < depth; ++i) text += open == "[" ? "]" : "}";
    return problem_of(text + "}").reason;
  };
  EXPECT_EQ(deep("[", 20), "");
  EXPECT_THAT(deep("[", test::some_of(1'000'000)), HasSubstr("nested more than 32 deep"));
  EXPECT_THAT(deep("{\"a\":", test::some_of(1'000'000)), HasSubstr("nested more than 32 deep"));
}

}  // namespace
}  // namespace labmouse
