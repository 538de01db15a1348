// Races of programs that drive a mouse themselves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <regex>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/text/number_rows.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

#if defined(LABMOUSE_CONTROLLER_TEMPLATE) && defined(LABMOUSE_BAD_PROGRAM)

namespace labmouse {
namespace {

using test::Says;
using testing::HasSubstr;

std::vector<Contestant> mice(const std::string& spec) {
  ExternalOptions options;
  options.limits.silence = options.limits.contest = std::chrono::minutes(5);
  const SpecResult read = read_specs(spec, options);
  EXPECT_EQ(read.error, "");
  return read.contestants;
}
std::vector<Contestant> controllers(const std::string& word = "") {
  return mice("controller:\"" LABMOUSE_CONTROLLER_TEMPLATE "\"" + (word.empty() ? word : " " + word));
}

std::shared_ptr<const World> world(const PhysicalConditions& conditions = test::at_variation(0.0)) {
  DriveRules rules = find_rules("all-japan").rules;
  rules.time_limit = 60'000'000;
  return physical_world(rules, test::drive_model("kerise"), conditions);
}

RaceOrder order_in(std::shared_ptr<const World> world, int runs = 2) {
  RaceOrder order;
  order.world = std::move(world);
  order.runs = runs;
  return order;
}

Race race(std::vector<Contestant> mice, const RaceHooks& hooks = {}) {
  return hold_race(std::move(mice), {{"ring", test::ring()}}, order_in(world()), hooks);
}

TEST(ControllerRace, IsHeldInThePhysicalWorldUnlessTold) {
  const EntriesResult entered = enter(controllers(), "", {});
  ASSERT_EQ(entered.error, "");
  const auto& entry = entered.entries.back();
  EXPECT_EQ(entry.world->traits().name, "physical");
  EXPECT_EQ(entry.mice.size(), 1U);
  for (const WorldEntry* other : all_worlds()) {
    const std::string error = enter(controllers(), other->name, {}).error;
    EXPECT_EQ(error.empty(), other->name == "physical") << other->name;
    EXPECT_TRUE(error.empty() || error.find("controller:\"" LABMOUSE_CONTROLLER_TEMPLATE "\"") != std::string::npos)
        << error;
  }
}

TEST(ControllerRace, IsTheSameAgain) {
  const Race first = race(controllers()), second = race(controllers());
  ASSERT_EQ(first.results.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(first.results[i].score);
    EXPECT_EQ(first.results[i].score, second.results[i].score);
    const StoredFigures& all = first.world().traits().fields->figures;
    EXPECT_EQ(all.values_of(*first.results[i].figures), all.values_of(*second.results[i].figures));
  }
  EXPECT_NE(first.results[0].score, first.results[1].score);
  // It may have seen anything, and nobody knows.
  const auto& figures = figures_of<PhysicalFigures>(first.results[0]);
  EXPECT_FALSE(figures.discovered);
  for (const auto& unknown : {figures.wall_error, figures.no_route_left, figures.wrong_walls, figures.contradictions})
    EXPECT_FALSE(unknown);
  EXPECT_TRUE(std::regex_search(table_of(first, false), std::regex("controller_template.* 0 +0 +- +- +0\\n")));
  EXPECT_THAT(table_of(first, false), HasSubstr("controller_template"));
}

TEST(ControllerRace, KeepsRecordsThatReplay) {
  LABMOUSE_SKIP_SANITIZED();
  std::vector<std::string> records;
  RaceHooks hooks;
  hooks.keep = [](const ContestResult&) { return Keep{true, true}; };
  hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput& held) {
    records.push_back(held.record);
    EXPECT_THAT(held.picture, HasSubstr("<svg"));
  };
  race(controllers(), hooks);
  ASSERT_EQ(records.size(), 2U);
  for (const std::string& text : records) {
    ReadDriveRecordResult read = read_drive_record(text);
    ASSERT_TRUE(read.file);
    EXPECT_EQ(write_drive_record(*read.file), text);
    EXPECT_EQ(replay_physically(*read.file), "");
    auto& tape = read.file->physical->notes.tape;
    ASSERT_GT(tape.size(), 5000U);
    // From there on it drives otherwise.
    tape[3000].left = static_cast<std::int16_t>(tape[3000].left / 2 + 1000);
    EXPECT_NE(replay_physically(*read.file), "");
  }
}

TEST(ControllerRace, KeepsRecordsThatReplayAsFarAsTheyGo) {
  LABMOUSE_SKIP_SANITIZED();
  std::string text;
  RaceHooks hooks;
  hooks.keep = [](const ContestResult&) { return Keep{true, false}; };
  hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput& held) { text = held.record; };
  race(controllers(), hooks);
  int parts = 0, lines = 0;
  for (std::size_t end = text.find('\n'); end + 1 < text.size(); end = text.find('\n', end + 1)) {
    // Tapes, runs and a few lines of the trace.
    if (++lines > 30 && lines % 100 != 0) continue;
    const ReadDriveRecordResult part = read_drive_record(std::string_view(text).substr(0, end + 1));
    if (!part.file) continue;
    ++parts;
    EXPECT_EQ(replay_physically(*part.file), "") << lines;
  }
  EXPECT_GT(parts, 10);
}

TEST(ControllerRace, HasTapesOfDutiesThatMotorsTake) {
  std::string text;
  RaceHooks hooks;
  hooks.keep = [](const ContestResult&) { return Keep{true, false}; };
  hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput& held) { text = held.record; };
  race(mice("controller:\"" LABMOUSE_BAD_PROGRAM "\" \"pilot give up\""), hooks);
  const std::string line = R"({"tape":"AA","said":[[0,"give up"]]})";
  const auto place = text.find(line);
  ASSERT_NE(place, std::string::npos) << text;
  ASSERT_TRUE(read_drive_record(text).file);
  constexpr auto least = std::numeric_limits<std::int32_t>::min();
  for (const std::int32_t duty : {ControllerTick::full + 1, -ControllerTick::full - 1, least, -(least + 1)}) {
    const std::string tape = R"({"tape":")" + rows_text(std::vector<std::int32_t>{0, duty}, 2) + R"(","said":[]})";
    EXPECT_FALSE(read_drive_record(std::string(text).replace(place, line.size(), tape)).file) << duty;
  }
}

TEST(ControllerRace, IsHeldBesideMiceOfOurs) {
  std::vector<Contestant> both = controllers();
  both.push_back(read_specs("flood-return").contestants.front());
  const Race held = race(std::move(both));
  for (const ContestResult& result : held.results) EXPECT_TRUE(result.score);
}

TEST(ControllerRace, TellsWhyAMouseGaveUp) {
  const Race held = race(mice("controller:\"" LABMOUSE_BAD_PROGRAM "\" \"pilot rubbish\""));
  for (const ContestResult& result : held.results) {
    EXPECT_FALSE(result.score);
    EXPECT_EQ(result.never_started, "");
  }
  EXPECT_THAT(table_of(held, false), Says("invalid answer", "'what?'"));
  const Race ended = race(mice("controller:\"" LABMOUSE_BAD_PROGRAM "\" \"pilot end at the start\""));
  for (const ContestResult& result : ended.results) EXPECT_THAT(result.never_started, HasSubstr("labmouse pilot 1"));
}

}  // namespace
}  // namespace labmouse

#endif
