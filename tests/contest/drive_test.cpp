#include "labmouse/contest/drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "labmouse/contest/drive_score.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "tests/contest/scripted.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/mouse/drive_robots.hpp"

namespace labmouse {
namespace {

using test::ring;
using test::Scripted;

constexpr Action on = Action::step(0, 1), left = Action::step(-90, 1), right = Action::step(90, 1);
constexpr Action reset = Action::reset();

/// Rules under which all counts, and the time in the maze by a tenth.
DriveRules plain_rules() {
  DriveRules rules;
  rules.time_limit = 100'000'000;
  rules.maze_time_divisor = 10;
  return rules;
}

/// Cells in 300 ms, small turns in 237, back in 3 s, pivots in 1.5 s a quarter.
const DriveModel& model() {
  static const DriveModel published = make_drive_model(published_robot());
  return published;
}

/// The way there.
const std::vector<Action> to_goal = {on, on, right, on, right};

DriveRecord held(std::vector<Action> script, const DriveRules& rules = plain_rules(), const Maze& maze = ring()) {
  Scripted mouse(std::move(script));
  return drive(maze, rules, model(), mouse);
}

std::vector<Action> then(std::vector<Action> first, const std::vector<Action>& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

TEST(Drive, CountsTheTimesOfASearch) {
  const DriveRecord record = held(then(to_goal, {reset}));
  const DriveRun& search = record.runs.front();
  EXPECT_EQ(search.kind, DriveRun::Kind::search);
  // Half a cell, a cell, a corner, a cell, a corner.
  EXPECT_EQ(search.gate_out, 300'000);
  EXPECT_EQ(search.gate_in, 300'000 + 300'000 + 237'000 + 300'000 + 237'000);
  EXPECT_EQ(search.end, search.gate_in);
  // It would stop half a cell behind.
  EXPECT_EQ(search.centre, *search.gate_in + 300'000);
  ASSERT_EQ(search.moves.size(), 5U);
  EXPECT_EQ(search.moves[2].begin, 600'000);
  EXPECT_EQ(search.moves[2].end, 837'000);
  EXPECT_EQ(search.moves[2].from, (Pose{{0, 2}, Heading::north}));
  EXPECT_EQ(search.moves[2].to, (Pose{{1, 2}, Heading::east}));
}

/// The same robot at twice its speed over known cells, which it reaches at once.
const DriveModel& dashing() {
  static const DriveModel fast = [] {
    Robot robot = published_robot();
    robot.known_speed = 600.0;
    robot.known_acceleration = 200'000.0;
    return make_drive_model(robot);
  }();
  return fast;
}

const Maze& corridor() {
  static const Maze maze = test::drawn(R"(
    o---o
    |   |
    o   o
    |   |
    o   o
    | G |
    o   o
    |   |
    o   o
    |   |
    o   o
    | S |
    o---o
  )");
  return maze;
}

/// Out of the start and to the edge of the last cell, through the goal.
const std::vector<Action> through_it = {on, Action::step(0, 4)};

TEST(Drive, DashesWhereItHasNothingToRead) {
  Scripted mouse(then(through_it, {Action::step(180, 0), reset}));
  const DriveRecord record = drive(corridor(), plain_rules(), dashing(), mouse);
  // There it has seen nothing before.
  const DriveRun& search = record.runs.front();
  EXPECT_EQ(search.moves.size(), 6U);
  EXPECT_EQ(search.gate_in, 300'000 + 2 * 300'000);
  EXPECT_EQ(search.centre, *search.gate_in + 150'000);
  // Home from the middle: half a cell at its search speed, four cells at once at twice that, and into the start.
  const DriveRun& home = record.runs[1];
  ASSERT_EQ(home.moves.size(), 3U);
  EXPECT_EQ(home.moves[1].action, Action::step(0, 4));
  EXPECT_EQ(home.moves[1].from, (Pose{{0, 4}, Heading::south}));
  EXPECT_EQ(home.moves[1].to, (Pose{{0, 0}, Heading::south}));
  EXPECT_EQ(home.moves[1].end - home.moves[1].begin, dashing().search.dash(4));
  EXPECT_LT(dashing().search.dash(4), 4 * 300'000 * 52 / 100);
}

TEST(Drive, PassesGatesInADash) {
  Scripted mouse(then(through_it, then({reset}, then(through_it, {reset}))));
  const DriveRecord record = drive(corridor(), plain_rules(), dashing(), mouse);
  ASSERT_GE(record.runs.size(), 5U);
  const DriveRun& again = record.runs[4];
  ASSERT_EQ(again.kind, DriveRun::Kind::search);
  ASSERT_EQ(again.moves.size(), 2U);
  const SearchDrive& search = dashing().search;
  const MazeTime out = again.moves[0].end;
  EXPECT_EQ(again.gate_out, out);
  EXPECT_EQ(again.gate_in, out + search.dash_part(4, 2));
  EXPECT_EQ(again.centre, out + (search.dash_part(4, 2) + search.dash_part(4, 3)) / 2);
  EXPECT_EQ(again.moves[1].end, out + search.dash(4));
}

TEST(Drive, ShowsWhatItPassesInADash) {
  Scripted mouse(then(through_it, {Action::step(180, 1), Action::step(0, 3), reset}));
  drive(corridor(), plain_rules(), dashing(), mouse);
  std::vector<Cell> shown;
  for (const auto& [pose, seen] : mouse.shown)
    if (pose.heading == Heading::south) shown.push_back(pose.cell);
  ASSERT_GE(shown.size(), 2U);
  EXPECT_EQ(shown[0], (Cell{0, 3}));
  EXPECT_EQ(shown[1], (Cell{0, 2}));
}

TEST(Drive, ComesHomeAndRuns) {
  const DriveRecord record = held(then(to_goal, {reset}));
  ASSERT_EQ(record.runs.size(), 3U);
  const DriveRun &home = record.runs[1], &fast = record.runs[2];
  EXPECT_EQ(home.kind, DriveRun::Kind::home);
  EXPECT_EQ(home.begin, 1'374'000);
  // Back out of the goal, a corner, a cell, a corner, two cells to the edge of the start; half a cell, and two pivots.
  EXPECT_EQ(home.end - home.begin,
            3'000'000 + 237'000 + 300'000 + 237'000 + 2 * 300'000 + 300'000 + 3'000'000 - 300'000);
  EXPECT_EQ(home.moves.back().to, (Pose{{0, 0}, Heading::north}));
  EXPECT_EQ(fast.kind, DriveRun::Kind::speed);
  EXPECT_EQ(fast.begin, home.end);
  EXPECT_EQ(fast.end, fast.begin + fast.route.time);
  EXPECT_EQ(fast.centre, fast.end);
  EXPECT_LT(fast.begin, *fast.gate_out);
  EXPECT_LT(*fast.gate_out, *fast.gate_in);
  EXPECT_LT(*fast.gate_in, *fast.centre);
  EXPECT_EQ(record.outcome, DriveOutcome::finished);
  EXPECT_EQ(record.reason, ForfeitReason::none);
}

TEST(Drive, RunsTheFastestKnownRoute) {
  const DriveRecord record = held(then(to_goal, {reset}));
  FastestRoutes routes(ring().size(), model().tables);
  routes.fill(ring().open_walls(), ring().goals());
  EXPECT_EQ(record.runs.back().route.time, routes.time_from({{0, 0}, Heading::north}));
  EXPECT_EQ(record.runs.back().known, record.runs.back().route.time);
  EXPECT_EQ(record.runs.front().known, no_time);
  EXPECT_LE(record.runs.front().possible, record.runs.back().possible);
}

TEST(Drive, TakesAStepOfManyCellsForAsManySteps) {
  Scripted one({on, on, right, on, right, reset}), many({Action::step(0, 2), Action::step(90, 2), right, reset});
  const DriveRecord first = drive(ring(), plain_rules(), model(), one);
  const DriveRecord second = drive(ring(), plain_rules(), model(), many);
  EXPECT_EQ(first.walls, second.walls);
  ASSERT_EQ(first.runs.size(), second.runs.size());
  EXPECT_EQ(first.runs[0].end, second.runs[0].end);
  EXPECT_EQ(first.runs[2], second.runs[2]);
  // What it did not decide on it was shown.
  ASSERT_GE(many.shown.size(), 2U);
  EXPECT_EQ(many.shown[0].first, (Pose{{0, 1}, Heading::north}));
  EXPECT_EQ(many.shown[0].second, (Sighting{0, 1, 0}));
  EXPECT_EQ(many.shown[1].first, (Pose{{1, 2}, Heading::east}));
}

TEST(Drive, ReadsNoFartherThanItsSensors) {
  Scripted mouse(then(to_goal, {reset}));
  drive(ring(), plain_rules(), model(), mouse);
  EXPECT_EQ(mouse.read.front(), (Sighting{0, 1, 0}));
  EXPECT_EQ(mouse.read[2], (Sighting{0, 0, 1}));
}

TEST(Drive, NotesEachWallWhenItIsFirstSeen) {
  const DriveRecord record = held(then(to_goal, {reset}));
  ASSERT_FALSE(record.walls.empty());
  EXPECT_EQ(record.walls[0], (WallSeen{0, wall_at({0, 0}, Heading::north), true}));
  EXPECT_EQ(record.walls[1], (WallSeen{0, wall_at({0, 0}, Heading::east), false}));
  for (std::size_t i = 0; i < record.walls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(record.walls[i].wall, record.walls[j].wall);
}

TEST(Drive, EndsWhereTheMouseDrivesIntoAWall) {
  const DriveRecord record = held({on, right});
  EXPECT_EQ(record.outcome, DriveOutcome::forfeit);
  EXPECT_EQ(record.reason, ForfeitReason::lost);
  EXPECT_EQ(record.runs.front().moves.size(), 1U);
}

TEST(Drive, EndsWhereTheMouseDrivesThroughAWallThatItHasNotSeen) {
  const Maze maze = test::drawn(R"(
    o---o
    | G |
    o   o
    |   |
    o   o
    | S |
    o   o
    |   |
    o---o
  )");
  EXPECT_EQ(held({Action::step(180, 1)}, plain_rules(), maze).reason, ForfeitReason::lost);
  EXPECT_EQ(held({right}, plain_rules(), maze).reason, ForfeitReason::lost);
  // A pivot shows it.
  EXPECT_EQ(held({Action::step(90, 0), Action::step(90, 1)}, plain_rules(), maze).runs.front().moves.size(), 2U);
}

TEST(Drive, EndsAtActionsWithoutSense) {
  for (const Action& action : {Action::step(0, 0), Action::step(45, 1), Action::step(0, -1), reset})
    EXPECT_EQ(held({action}).reason, ForfeitReason::lost);
  EXPECT_EQ(held({Action::forfeit(ForfeitReason::no_route)}).reason, ForfeitReason::no_route);
}

TEST(Drive, EndsWithItsTime) {
  DriveRules rules = plain_rules();
  rules.time_limit = 1'000'000;
  const DriveRecord record = held(then(to_goal, {reset}), rules);
  EXPECT_EQ(record.outcome, DriveOutcome::out_of_time);
  EXPECT_EQ(record.runs.size(), 1U);
  EXPECT_FALSE(score(record, rules).best);
}

TEST(Drive, IsFinishedWhereOnlyTheSearchCameToTheGoalInTime) {
  DriveRules rules = plain_rules();
  rules.time_limit = 2'000'000;
  const DriveRecord record = held(then(to_goal, {reset}), rules);
  EXPECT_EQ(record.outcome, DriveOutcome::finished);
  ASSERT_TRUE(score(record, rules).best);
  EXPECT_EQ(score(record, rules).value(), 1'374'000 - 300'000);
}

TEST(Drive, LetsNoMoreRunsBeginThanTheRulesAllow) {
  DriveRules rules = plain_rules();
  rules.most_runs = 3;
  const DriveRecord record = held(then(to_goal, {reset, reset, reset, reset}), rules);
  ASSERT_EQ(record.runs.size(), 4U);
  EXPECT_EQ(record.runs[2].route, record.runs[3].route);
  EXPECT_EQ(record.runs[3].begin, record.runs[2].end);
  EXPECT_EQ(record.outcome, DriveOutcome::finished);
}

TEST(Drive, LetsAMouseSearchAgain) {
  const DriveRecord record = held(then(to_goal, {reset, on, on, right, on, right, on, reset}));
  ASSERT_EQ(record.runs.size(), 7U);
  EXPECT_EQ(record.runs[3].kind, DriveRun::Kind::home);
  EXPECT_EQ(record.runs[3].begin, record.runs[2].end);
  EXPECT_EQ(record.runs[4].kind, DriveRun::Kind::search);
  EXPECT_EQ(record.runs[4].moves.front().from, (Pose{{0, 0}, Heading::north}));
  EXPECT_EQ(record.runs[6].kind, DriveRun::Kind::speed);
  EXPECT_GT(record.runs[6].open.count(), record.runs[2].open.count());
}

TEST(Drive, HasTheMiddleOfAGoalWhereTheMousePassesIt) {
  // Through the goal, and a corner in a goal does not pass its middle.
  const DriveRecord passing = held(then(to_goal, {on}));
  EXPECT_EQ(passing.runs.front().centre, *passing.runs.front().gate_in + 150'000);
  const DriveRecord turning = held({on, on, right, on, right}, plain_rules(), ring().with_goals(CellSet::of({0, 2})));
  EXPECT_FALSE(turning.runs.front().centre);
}

TEST(Drive, LetsAMouseThatStartsInTheGoalBeDoneAtOnce) {
  const Maze maze = ring().with_goals(CellSet::of({0, 0}));
  const DriveRecord record = held({reset}, plain_rules(), maze);
  EXPECT_EQ(record.outcome, DriveOutcome::finished);
  ASSERT_EQ(record.runs.size(), 2U);
  EXPECT_EQ(score(record, plain_rules()).value(), 0);
}

TEST(DriveScore, AddsThePartOfTheTimeInTheMaze) {
  const DriveRecord record = held(then(to_goal, {reset}));
  const DriveScore found = score(record, plain_rules());
  ASSERT_EQ(found.runs.size(), 2U);
  const DriveRunScore &search = found.runs[0], &fast = found.runs[1];
  EXPECT_EQ(search.run, 0U);
  EXPECT_EQ(search.value, 1'074'000);
  EXPECT_EQ(fast.run, 2U);
  EXPECT_EQ(fast.maze_time, record.runs[2].begin / 10);
  EXPECT_EQ(fast.value, *fast.gate_to_gate + fast.maze_time);
  EXPECT_EQ(fast.rest_to_centre, record.runs[2].route.time);
  EXPECT_EQ(found.best, 0U);
}

TEST(DriveScore, GoesByTheRules) {
  const DriveRecord record = held(then(to_goal, {reset}));
  DriveRules rules;
  rules.time_limit = 100'000'000;
  EXPECT_EQ(score(record, rules).best, 1U);
  EXPECT_EQ(score(record, rules).value(), *record.runs[2].gate_in - *record.runs[2].gate_out);
  rules.gate_to_gate = false;
  EXPECT_EQ(score(record, rules).value(), record.runs[2].route.time);
  rules.untouched_bonus = 100'000;
  EXPECT_EQ(score(record, rules).value(), record.runs[2].route.time - 100'000);
  rules.time_limit = record.runs[2].end - 1;
  EXPECT_EQ(score(record, rules).runs.size(), 1U);
}

TEST(DriveScore, RoundsThePartToTheNearestMicrosecond) {
  DriveRules rules;
  EXPECT_EQ(maze_time_part(100, rules), 0);
  rules.maze_time_divisor = 30;
  EXPECT_EQ(maze_time_part(44, rules), 1);
  EXPECT_EQ(maze_time_part(45, rules), 2);
}

TEST(DriveGates, LieOnTheEdgesOfTheCells) {
  const Maze maze = test::drawn(R"(
    o---o
    | G |
    o   o
    |   |
    o   o
    | S |
    o---o
  )");
  const DriveRecord record = held({on, on, reset}, plain_rules(), maze);
  const DriveRun& fast = record.runs.back();
  // Published robots start at 420 mm/s: half a cell, and the same backwards, with the speed they end with.
  const double seconds = (std::sqrt(420.0 * 420.0 + 2 * 4200.0 * 45.0) - 420.0) / 4200.0;
  EXPECT_NEAR(static_cast<double>(*fast.gate_out - fast.begin), seconds * 1e6, 2);
  EXPECT_NEAR(static_cast<double>(fast.end - *fast.gate_in), seconds * 1e6, 2);
}

TEST(DriveGates, MayLieInsideATurn) {
  const Maze maze = test::drawn(R"(
    o---o---o
    |     G |
    o   o---o
    | S |   |
    o---o---o
  )");
  const DriveRecord record = held({on, right, reset}, plain_rules(), maze);
  const DriveRun& fast = record.runs.back();
  // One turn from middle to middle, the same from both ends.
  ASSERT_EQ(fast.route.segments.size(), 1U);
  EXPECT_NEAR(static_cast<double>(*fast.gate_out - fast.begin), static_cast<double>(fast.end - *fast.gate_in), 2);
  EXPECT_GT(*fast.gate_out - fast.begin, 375'000 / 4);
  EXPECT_LT(*fast.gate_out - fast.begin, 375'000 / 2);
}

}  // namespace
}  // namespace labmouse
