// Crashes as the page shows them: at their moment, in their cell, with their run.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "labmouse/contest/failure_rates.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/replays/play_seconds.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::json;

json play_of(const DriveRecordFile& file) { return json::parse(play_json(file).dump()); }

/// The frame in which that run crashed; -1 where its play has none.
int crash_frame(const json& play, const json& run) {
  for (std::size_t frame = 1; frame < play["clock"].size(); ++frame)
    if (play["blocked"][frame - 1] == true && std::llround(play["clock"][frame].get<double>() * 1e6) == run["end"])
      return static_cast<int>(frame);
  return -1;
}

/// The crash of that run has a frame in its cell, and the path ends in it.
void expect_shown(const json& play, const json& run, Cell cell) {
  EXPECT_EQ(run["crash"]["cell"], json({cell.x, cell.y}));
  EXPECT_EQ(run["crash"]["time"].get<double>(), run["end"].get<double>());
  const int frame = crash_frame(play, run);
  ASSERT_GT(frame, 0);
  EXPECT_EQ(play["x"][frame], 2 * cell.x + 1);
  EXPECT_EQ(play["y"][frame], 2 * cell.y + 1);
  const json& path = play["drive"]["path"];
  const std::size_t last = run["to"].get<std::size_t>() - 1;
  EXPECT_EQ(path["t"][last], run["end"]);
  EXPECT_EQ(std::floor(path["x"][last].get<double>()), cell.x);
  EXPECT_EQ(std::floor(path["y"][last].get<double>()), cell.y);
}

DriveRecordFile physical(int trace_every, std::uint64_t seed) {
  PhysicalConditions conditions = test::at_errors(2.5);
  conditions.trace_every = trace_every;
  return test::physical_file("flood-return", conditions, seed);
}

TEST(PageCrash, OfAMouseInThePhysicalWorldIsWhereItsBodyWas) {
  LABMOUSE_SKIP_SANITIZED();
  int crashes = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const int trace_every : {0, 100}) {
      const DriveRecordFile file = physical(trace_every, seed);
      const json play = play_of(file), &runs = play["drive"]["runs"];
      for (const WallTouch& touch : file.physical->notes.touches) {
        if (!touch.crash) continue;
        ++crashes;
        const auto run =
            std::find_if(runs.begin(), runs.end(), [&](const json& one) { return one["end"] == touch.time; });
        ASSERT_NE(run, runs.end());
        expect_shown(play, *run,
                     {static_cast<int>(touch.at.position.x / 90.0), static_cast<int>(touch.at.position.y / 90.0)});
      }
    }
  EXPECT_GT(crashes, 4);
}

TEST(PageCrash, IsOfTheShapeThatThePageAsksFor) {
  const json play = test::answer("open", {{"name", "a.jsonl"}}, write_drive_record(physical(20, 1)))["play"];
  const json& path = play["drive"]["path"];
  EXPECT_EQ(play["drive"]["bodies"]["belief"]["x"].size(), path["x"].size());
  EXPECT_EQ(play["drive"]["bodies"]["distances"].size(), 4 * path["x"].size());
}

/// A contest in which that manoeuvre always fails.
DriveRecordFile failing(Manoeuvre manoeuvre) {
  FailureRates failure_rates;
  failure_rates.paces = {{1.0, {no_failures()}}};
  failure_rates.paces.front().variations.front().variation = 1.0;
  for (FailureRatesByBrightness& by_brightness : failure_rates.paces.front().variations.front().by_brightness)
    by_brightness.manoeuvres[static_cast<std::size_t>(manoeuvre)][0] = {1.0, 1.0, {1.0}};
  DriveRecordFile file = test::physical_file("flood-return", test::at_errors(1.0));
  const Briefing briefing = [&] {
    Briefing made = brief(*file.maze, file.rules, *file.model, 1);
    made.sight = 1;
    return made;
  }();
  const BuiltinMouse& entry = *find_mouse("flood-return");
  const auto mouse = entry.drive(briefing, Settings(entry.parameters));
  PhysicalRecord record =
      drive_with_failures(*file.maze, file.rules, *file.model, file.physical->conditions, failure_rates, 1, *mouse);
  file.record = std::move(record.drive);
  file.physical->notes = std::move(record);
  return file;
}

TEST(PageCrash, OfASearchWithTheFailureModelIsInTheCellThatItWasAboutToCross) {
  const json play = play_of(failing(Manoeuvre::turn));
  for (const json& run : play["drive"]["runs"]) {
    EXPECT_EQ(run["ended"], "slid");
    expect_shown(play, run, {0, 2});
  }
}

TEST(PageCrash, OfASpeedRunWithTheFailureModelIsOnItsRoute) {
  const DriveRecordFile file = failing(Manoeuvre::run_straight);
  const json play = play_of(file), &runs = play["drive"]["runs"];
  int crashes = 0;
  for (const json& run : runs) {
    EXPECT_EQ(run["crash"].is_null(), run["kind"] != "speed");
    if (run["kind"] != "speed") continue;
    ++crashes;
    const Cell cell = {run["crash"]["cell"][0], run["crash"]["cell"][1]};
    EXPECT_EQ(cell.x, 0) << "on the first straight";
    expect_shown(play, run, cell);
  }
  EXPECT_GT(crashes, 0);
}

TEST(PageCrash, IsNoPartOfAContestInWhichNothingFails) {
  const json play = play_of(test::driven("flood-return"));
  for (const json& run : play["drive"]["runs"]) {
    EXPECT_TRUE(run["crash"].is_null());
    EXPECT_TRUE(run["ended"].is_null());
  }
}

}  // namespace
}  // namespace labmouse
