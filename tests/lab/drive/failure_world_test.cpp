// Files of failure rates, races in the failure model, and how it compares with the physical world.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/drive/drive_entries.hpp"
#include "labmouse/lab/drive/fidelity.hpp"
#include "labmouse/lab/failure_rates/failure_file.hpp"
#include "labmouse/lab/finish_curves/finish_curves.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "tests/lab/drive/failures_fixture.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::at;
using test::order_of;
using test::Says;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// As `labmouse failure rates` counts them.
std::string counted(const FailureOrder& order) {
  const auto mice = test::mice("flood-return");
  const std::vector<NamedMaze> mazes = {{"ring", test::ring()}};
  return write_rates(measure_rates(order, mice, mazes), order, mice, mazes.size());
}

TEST(FailureFile, HasAllThatWasCounted) {
  const FailureOrder order = order_of({1.0, 4.0}, 3);
  const auto tallies =
      measure_rates(order, test::mice("flood-return"), std::vector<NamedMaze>{{"ring", test::ring()}}).tallies;
  const FoundRates read = read_rates(counted(order), "some/mine.json");
  ASSERT_TRUE(read.file) << read.error;
  EXPECT_EQ(read.file->tallies, tallies);
  EXPECT_EQ(read.file->name, "mine");
  EXPECT_EQ(read.file->robot, "kerise");
  EXPECT_EQ(read.file->noise, order.conditions.errors.noise);
}

TEST(FailureFile, RefusesWhatIsNone) {
  const std::string good = counted(order_of({1.0}, 1));
  const auto refused = [&](auto change) {
    auto json = nlohmann::json::parse(good);
    change(json);
    const FoundRates read = read_rates(json.dump(), "mine.json");
    EXPECT_FALSE(read.file);
    return read.error;
  };
  EXPECT_THAT(read_rates("{}", "mine.json").error, Says("mine.json", "no file of failure rates"));
  EXPECT_THAT(refused([](auto& json) { json["labmouse_failure_rates"] = 99; }), HasSubstr("labmouse_failure_rates"));
  EXPECT_THAT(refused([](auto& json) { json["variations"] = nlohmann::json::array(); }), HasSubstr("variations"));
  EXPECT_THAT(refused([](auto& json) { json["variations"].push_back(json["variations"][0]); }), HasSubstr("increase"));
  EXPECT_THAT(refused([](auto& json) { json["variations"][0]["by_brightness"].erase(0); }), HasSubstr("by_brightness"));
  EXPECT_THAT(refused([](auto& json) { json["variations"][0]["by_brightness"][0]["put"] = {-1}; }), HasSubstr("put"));
  EXPECT_THAT(refused([](auto& json) { json["variations"][0]["by_brightness"][0].erase("readings"); }),
              HasSubstr("readings"));
  EXPECT_THAT(refused([](auto& json) {
                json["variations"][0]["by_brightness"][0]["manoeuvres"]["turn"][0] = {3, 1, 0, 1};
              }),
              HasSubstr("add up"));
  EXPECT_THAT(refused([](auto& json) {
                json["variations"][0]["by_brightness"][0]["readings"]["gap ahead"][0] = std::vector<int>(18, 1);
              }),
              HasSubstr("gap ahead"));
  EXPECT_THAT(find_rates("kerize").error, Says("kerize", "kerise"));
}

TEST(FailureFile, SaysHowLikelyAllIs) {
  FailureFile file;
  FailureTally& tally = file.tallies.emplace_back();
  tally.variation = 1.2;
  auto& turns = tally.by_brightness[1].manoeuvres[static_cast<std::size_t>(Manoeuvre::turn)][0];
  turns = {100'000, 10'000, 2'500, {45'000, 45'000, 0, 0, 0}};
  tally.by_brightness[1].readings[static_cast<std::size_t>(Reading::gap_beside)][0].by_evidence[evidence_classes - 1] =
      1000;
  const FailureRates failure_rates = rates_of(file);
  // Without variation nothing goes wrong.
  ASSERT_THAT(failure_rates.paces, SizeIs(1));
  const auto& variations = failure_rates.paces[0].variations;
  ASSERT_THAT(variations, SizeIs(2));
  EXPECT_EQ(variations[0].variation, 0.0);
  EXPECT_EQ(variations[1].variation, 1.2);
  FailureRatesByBrightness counted = variations[1].by_brightness[1], other = variations[1].by_brightness[4];
  EXPECT_NEAR(at(counted, Manoeuvre::turn).crash, 0.1, 1e-3);
  EXPECT_NEAR(at(counted, Manoeuvre::turn).slid, 0.25, 1e-3);
  EXPECT_NEAR(at(counted, Manoeuvre::turn).after[1], 0.5, 1e-3);
  // What was not counted is as it is elsewhere, and what was counted nowhere stays as it is.
  EXPECT_NEAR(at(other, Manoeuvre::turn).crash, 0.1, 1e-3);
  EXPECT_NEAR(at(other, Manoeuvre::corridor).crash, 0.1, 1e-3);
  EXPECT_EQ(at(other, Manoeuvre::corridor, 3).crash, 0.0);
  EXPECT_EQ(at(other, Manoeuvre::corridor, 3).after[3], 1.0);
  const auto& gaps = counted.readings[static_cast<std::size_t>(Reading::gap_beside)];
  EXPECT_GT(gaps[0][evidence_classes - 1], 0.95);
  EXPECT_EQ(gaps[1][0], 1.0);
}

TEST(FailureWorld, IsMadeOfWhatItIsToldAndMadeAgainOfItsConditions) {
  const WorldResult made = failures_entry.make({{"variation", "1.1"}, {"map", "log-odds"}});
  ASSERT_TRUE(made.world) << made.error;
  RaceOrder order;
  order.world = made.world;
  order.runs = 2;
  const Race race = hold_race(test::mice("flood"), {{"ring", test::ring()}}, order);
  const auto group = nlohmann::json::parse(json_of(race, {})).at("groups").at(0);
  EXPECT_EQ(group.at("world"), "failures");
  EXPECT_EQ(group.at("failure_rates"), "kerise");
  EXPECT_EQ(group.at("map"), "log-odds");
  const auto again = restore_world("failures", group.dump());
  ASSERT_TRUE(again);
  order.world = again;
  const Race twice = hold_race(test::mice("flood"), {{"ring", test::ring()}}, order);
  EXPECT_EQ(json_of(twice, {}), json_of(race, {}));
  auto other = group;
  other["failure_rates_hash"] = "0";
  EXPECT_FALSE(restore_world("failures", other.dump()));
}

TEST(FailureWorld, RefusesWhatItCannotUse) {
  const auto error = [](const WorldSettings& settings) {
    const WorldResult made = failures_entry.make(settings);
    EXPECT_FALSE(made.world);
    return made.error;
  };
  EXPECT_THAT(error({{"variation", "7"}}), Says("--variation", "7", "kerise"));
  EXPECT_THAT(error({{"robot", "classic"}}), Says("--failure-rates", "kerise", "classic"));
  EXPECT_THAT(error({{"failure-rates", "none"}}), HasSubstr("none"));
  EXPECT_THAT(error({{"map", "none"}}), HasSubstr("--map"));
}

TEST(FailureWorld, KeepsRecordsThatAreDrivenAgainByTheFailureRatesThatTheProgramBrings) {
  LABMOUSE_SKIP_SANITIZED();
  RaceOrder order;
  order.world = failures_entry.make({{"variation", "1.5"}, {"pace", "0.8"}}).world;
  order.runs = 3;
  RaceHooks hooks;
  std::vector<std::string> records;
  hooks.keep = [](const ContestResult&) { return Keep{true, false}; };
  hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput& held) {
    records.push_back(held.record);
  };
  hold_race(test::mice("festina"), {{"ring", test::ring()}}, order, hooks);
  ASSERT_THAT(records, SizeIs(3));
  for (const std::string& text : records) {
    ReadDriveRecordResult read = read_drive_record(text);
    ASSERT_TRUE(read.file) << describe("", read.problems.front());
    EXPECT_TRUE(read.file->physical->notes.by_failure_model);
    EXPECT_EQ(world_of(*read.file), "failures");
    EXPECT_EQ(read.file->physical->conditions.map, MapKind::log_odds);
    const auto& runs = read.file->record.runs;
    EXPECT_TRUE(std::any_of(runs.begin(), runs.end(), [](const DriveRun& run) { return run.pace < 1.0; }));
    EXPECT_EQ(replay_physically(*read.file), "");
    read.file->record.runs.front().pace = 0.5;
    EXPECT_THAT(replay_physically(*read.file), HasSubstr("line"));
    read.file->physical->rates_hash = "0";
    EXPECT_THAT(replay_physically(*read.file), Says("kerise", "not driven again"));
    read.file->physical->edition = failures_edition + 1;
    EXPECT_THAT(replay_physically(*read.file), Says("failures", "edition"));
  }
}

TEST(FailureWorld, RacesOnceForEachVariation) {
  const auto entered = enter(test::mice("flood,certify"), "failures", {{"variation", "lab,1.1,bad-day"}});
  ASSERT_EQ(entered.error, "");
  ASSERT_THAT(entered.entries, SizeIs(3));
  EXPECT_THAT(enter(test::mice("flood"), "failures", {{"variation", "0,,1"}}).error, HasSubstr("--variation"));
  EXPECT_THAT(sole_entry(entered.entries).error, HasSubstr("one"));
}

TEST(FinishCurves, ShowWhatBecomesOfMiceAsVariationGrows) {
  std::vector<Race> races;
  for (const auto& entry : enter(test::mice("flood,certify"), "failures", {{"variation", "1.5,0"}}).entries) {
    RaceOrder order;
    order.world = entry.world;
    order.runs = 30;
    races.push_back(hold_race(entry.mice, {{"ring", test::ring()}}, order));
  }
  const auto curves = finish_curves(races);
  EXPECT_EQ(curves.scale, "variation");
  ASSERT_THAT(curves.curves, SizeIs(2));
  for (const FinishCurve& curve : curves.curves) {
    ASSERT_THAT(curve.points, SizeIs(2));
    EXPECT_EQ(curve.points[0].at, 0.0);
    EXPECT_EQ(curve.points[0].finished, 30);
    const FinishPoint& last = curve.points[1];
    int ended = 0;
    for (const int count : last.ended) ended += count;
    EXPECT_EQ(last.contests, 30);
    EXPECT_EQ(last.finished + ended, 30);
    EXPECT_GE(*last.par1, *curve.points[0].par1);
  }
  EXPECT_THAT(table_of(curves, races.back().world()), Says("flood", "certify", "100.0", "in s;", "counts 300"));
  const std::string picture = draw_curves(curves, "A <title>");
  EXPECT_THAT(picture, Says("<svg", "certify", "&lt;title&gt;"));
  EXPECT_THAT(finish_curves(std::span(races).first(1)).curves, IsEmpty());
}

TEST(Fidelity, ComparesTheSameContestsInBothWorlds) {
  const FailureOrder order = order_of({0.0, 1.0}, 2);
  const FoundRates failure_rates = find_rates("kerise");
  ASSERT_TRUE(failure_rates.file) << failure_rates.error;
  const std::vector<NamedMaze> mazes = {{"ring", test::ring()}, {"other", test::ring()}};
  const auto all = compare_worlds(order, *failure_rates.file, test::mice("flood,certify"), mazes);
  ASSERT_THAT(all, SizeIs(4));
  EXPECT_EQ(all[0].contests, 4);
  EXPECT_EQ(all[0].physical, 4);
  EXPECT_EQ(all[0].failures, 4);
  EXPECT_TRUE(is_faithful(all[0], {}));
  Fidelity far = {"m", 1.0, 100, 90, 86, -0.04, Interval{-0.045, -0.035}};
  EXPECT_FALSE(is_faithful(far, {}));
  EXPECT_TRUE(is_faithful(far, {0.04, 0.05}));
  far.interval = Interval{-0.06, 0.0};
  EXPECT_FALSE(is_faithful(far, {0.04, 0.05}));
  EXPECT_THAT(table_of(std::vector{far}, {}), Says("too far", "-4.0"));
}

}  // namespace
}  // namespace labmouse
