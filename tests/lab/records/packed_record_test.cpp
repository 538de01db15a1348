#include "labmouse/lab/records/packed_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "labmouse/contest/script.hpp"
#include "tests/lab/records/record_fixture.hpp"
#include "tests/maze/random_maze.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::recorded;
using test::Says;

/// What comes back of a record that was packed, written as text, read and played.
RecordFile unpacked(const RecordFile& file) {
  const auto json = nlohmann::json::parse(pack_record(file).dump());
  UnpackResult result = unpack_record(json, *file.maze);
  EXPECT_EQ(result.error, "");
  if (!result.file) return {};
  ReplayResult played = replay(*result.file, *file.maze);
  EXPECT_EQ(played.disagreement, "");
  result.file->run = std::move(played.run);
  return std::move(*result.file);
}

std::string error_of(const nlohmann::json& json) {
  const UnpackResult result = unpack_record(json, test::loop().maze);
  EXPECT_EQ(result.file.has_value(), result.error.empty());
  return result.error;
}

nlohmann::json with_actions(const std::string& actions) {
  return {{"mouse", "flood"}, {"maze", "loop"}, {"actions", actions}};
}

std::vector<Action> actions_of(const std::string& text) {
  std::vector<Action> actions;
  const UnpackResult result = unpack_record(with_actions(text), test::loop().maze);
  EXPECT_EQ(result.error, "") << text;
  if (result.file)
    for (const StepRecord& step : result.file->run.steps) actions.push_back(step.action);
  return actions;
}

TEST(PackedRecord, PlaysToTheWholeRecord) {
  for (const auto& maze : {test::loop(), test::corridor(), test::without_route()})
    for (const char* mouse : {"flood", "random", "oracle", "visit-counter", "certify"}) {
      const RecordFile file = recorded(mouse, maze, 9007199254740991U);
      const RecordFile again = unpacked(file);
      EXPECT_EQ(again.run, file.run) << mouse << " in " << maze.name;
      EXPECT_EQ(again.mouse, mouse);
      EXPECT_EQ(again.maze_name, maze.name);
      EXPECT_EQ(again.seed, file.seed);
      EXPECT_EQ(again.rules, file.rules);
      EXPECT_TRUE(again.ended);
    }
}

TEST(PackedRecord, KeepsRulesLastWordsAndAnEndThatIsMissing) {
  RecordFile file = recorded("flood");
  file.rules = {5000, 20, 8, 100.0};
  file.run.last_words = "a word\nand another";
  EXPECT_EQ(unpacked(file).rules, file.rules);
  EXPECT_EQ(unpacked(file).run.last_words, file.run.last_words);
  file.ended = false;
  file.run.steps.resize(2);
  EXPECT_FALSE(unpacked(file).ended);
  EXPECT_EQ(unpacked(file).run.steps, file.run.steps);
}

TEST(PackedRecord, KeepsSeedsThatJavaScriptWouldRound) {
  const RecordFile file = recorded("flood", test::loop(), 18446744073709551615U);
  EXPECT_EQ(pack_record(file)["seed"], "18446744073709551615");
  EXPECT_EQ(unpacked(file).seed, file.seed);
  EXPECT_EQ(pack_record(recorded("flood", test::loop(), std::uint64_t{1} << 53U))["seed"], std::uint64_t{1} << 53U);
}

TEST(PackedRecord, OfAUsualStepIsOneCharacter) {
  const auto json = pack_record(recorded("certify"));
  EXPECT_EQ(json["actions"].get<std::string>().size(), recorded("certify").run.steps.size());
  EXPECT_FALSE(json.contains("rules"));
  EXPECT_FALSE(json.contains("last_words"));
  EXPECT_FALSE(pack_record(recorded("flood")).contains("counts"));
  EXPECT_EQ(actions_of("aghknouR"),
            (std::vector{Action::step(-90, -3), Action::step(-90, 3), Action::step(0, -3), Action::step(0, 0),
                         Action::step(0, 3), Action::step(90, -3), Action::step(90, 3), Action::reset()}));
}

TEST(PackedRecord, KeepsActionsThatNoMouseShouldTake) {
  constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  const NamedMaze maze = test::loop();
  RecordFile file = recorded("flood", maze);
  Script script(maze.maze.size(), {Action::step(45, 1), Action::step(least, most), Action::step(90, 4),
                                   Action::step(0, least), Action::reset(), Action::forfeit(ForfeitReason::closed)});
  file.run = run(maze.maze, Rules(), script);
  EXPECT_EQ(pack_record(file)["actions"], "(45,1)(-2147483648,2147483647)(90,4)(0,-2147483648)R!closed its pipes;");
  EXPECT_EQ(unpacked(file).run, file.run);
}

TEST(PackedRecord, KeepsEveryReasonOfAForfeit) {
  for (const ForfeitReason reason : all_forfeit_reasons)
    EXPECT_EQ(actions_of("n!" + std::string(name_of(reason)) + ";").back(), Action::forfeit(reason));
}

TEST(PackedRecord, MayHaveReasonsOfEarlierVersions) {
  EXPECT_EQ(actions_of("n!died;").back(), Action::forfeit(ForfeitReason::ended_early));
  EXPECT_EQ(actions_of("n!rubbish;").back(), Action::forfeit(ForfeitReason::invalid_answer));
  EXPECT_EQ(actions_of("n!no way;").back(), Action::forfeit(ForfeitReason::no_route));
}

RC_GTEST_PROP(PackedRecord, HoldsAnyActions, ()) {
  const auto number = rc::gen::oneOf(rc::gen::inRange(-4, 5), rc::gen::element(-90, 90), rc::gen::arbitrary<int>());
  const auto action = rc::gen::oneOf(rc::gen::apply(Action::step, number, number), rc::gen::just(Action::reset()),
                                     rc::gen::map(rc::gen::elementOf(all_forfeit_reasons), Action::forfeit));
  RecordFile file = recorded("flood");
  file.run = {};
  for (const Action& each : *rc::gen::container<std::vector<Action>>(action)) {
    file.run.steps.emplace_back().action = each;
    file.run.steps.back().step = static_cast<int>(file.run.steps.size());
  }
  const UnpackResult result = unpack_record(nlohmann::json::parse(pack_record(file).dump()), *file.maze);
  RC_ASSERT(result.error.empty());
  RC_ASSERT(result.file->run.steps == file.run.steps);
  RC_ASSERT(result.file->given == std::vector(file.run.steps.size(), GivenFields{false, false, false, false, false}));
}

TEST(PackedRecord, SaysWhichActionIsNone) {
  EXPECT_THAT(error_of(with_actions("nv")), Says("'record'", "character 2 ", "'actions'"));
  EXPECT_THAT(error_of(with_actions("(45,1)n*")), Says("'record'", "character 8 ", "'actions'"));
  for (const char* bad : {"A",
                          "`",
                          "r ",
                          "\xff",
                          "(",
                          "(1",
                          "(1,",
                          "(1,2",
                          "(1,2]",
                          "(01,2)",
                          "(+1,2)",
                          "( 1,2)",
                          "(-0,2)",
                          "(,2)",
                          "(1,)",
                          "(0,1)",
                          "(90,-3)",
                          "(2147483648,1)",
                          "(1,-2147483649)",
                          "!",
                          "!;",
                          "!lost",
                          "!Lost;",
                          "!lost ;",
                          "!sleepy;"})
    EXPECT_THAT(error_of(with_actions(bad)), Says("no action", "'actions'")) << bad;
}

TEST(PackedRecord, ThatIsTooLongIsRefused) {
  EXPECT_EQ(actions_of(std::string(1'000'000, 'k')).size(), 1'000'000U);
  EXPECT_THAT(error_of(with_actions(std::string(1'000'001, 'k'))), Says("'record'", "1000000 actions"));
}

TEST(PackedRecord, SaysWhichFieldIsWrong) {
  using Json = nlohmann::json;
  EXPECT_EQ(error_of(with_actions("k")), "");
  for (const Json& none : {Json(), Json(7), Json("flood"), Json::array()})
    EXPECT_THAT(error_of(none), Says("'record'", "object"));
  const auto with = [](const char* key, const Json& value) {
    Json json = with_actions("k");
    json[key] = value;
    return error_of(json);
  };
  EXPECT_THAT(with("mouse", 7), Says("'record.mouse'", "string"));
  EXPECT_THAT(with("maze", nullptr), Says("'record.maze'", "string"));
  EXPECT_THAT(with("actions", Json::array()), Says("'record.actions'", "string"));
  EXPECT_THAT(with("last_words", 7), Says("'record.last_words'", "string"));
  EXPECT_THAT(with("outcome", 7), Says("'record.outcome'", "string"));
  EXPECT_THAT(with("outcome", "won"), Says("'record'", "outcome", "version"));
  for (const Json& seed :
       {Json(-1), Json(1.5), Json(""), Json("-1"), Json("1 "), Json("18446744073709551616"), Json(true)})
    EXPECT_THAT(with("seed", seed), Says("'record'", "seed", "2^64 - 1")) << seed;
  EXPECT_THAT(with("rules", {{"stride", 9}}), Says("'rules.stride'", "1 to 8"));
  EXPECT_THAT(with("counts", 7), Says("'counts'", "object"));
  Json json = with_actions("k");
  json.erase("actions");
  EXPECT_THAT(error_of(json), Says("'record.actions'", "missing"));
}

TEST(PackedRecord, OfAnotherMazeIsToldByItsReplay) {
  const RecordFile file = recorded("flood", test::loop());
  const Maze other = test::corridor().maze;
  const UnpackResult result = unpack_record(nlohmann::json::parse(pack_record(file).dump()), other);
  ASSERT_TRUE(result.file);
  EXPECT_NE(replay(*result.file, other).disagreement, "");
}

}  // namespace
}  // namespace labmouse
