#include "labmouse/lab/records/drive_record_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/contest/drive_gates.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/lab/bounds/drive_bound.hpp"
#include "labmouse/lab/records/drive_route_check.hpp"
#include "tests/contest/scripted.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using test::driven;
using test::ProblemAt;
using test::Says;
using test::SaysAt;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

DriveRecordFile read(const std::string& text) {
  ReadDriveRecordResult result = read_drive_record(text);
  EXPECT_TRUE(result.file) << (result.problems.empty() ? "" : result.problems.front().reason);
  return std::move(*result.file);
}

Problem problem(const std::string& text) {
  const ReadDriveRecordResult result = read_drive_record(text);
  EXPECT_FALSE(result.file);
  return result.problems.empty() ? Problem() : result.problems.front();
}

std::string changed(std::string text, const std::string& old, const std::string& now) {
  const auto place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return place == std::string::npos ? text : text.replace(place, old.size(), now);
}

const std::string& good() {
  static const std::string text = write_drive_record(driven("certify"));
  return text;
}

std::string disagreement(const std::string& old, const std::string& now) {
  return replay(read(changed(good(), old, now)));
}

TEST(DriveRecordFile, SaysWhatANamedMouseIs) {
  DriveRecordFile written = driven("flood");
  written.mouse = "fast";
  written.spec = "flood";
  const DriveRecordFile file = read(write_drive_record(written));
  EXPECT_EQ(file.mouse, "fast");
  EXPECT_EQ(file.spec, "flood");
  EXPECT_EQ(read(good()).spec, "");
}

TEST(DriveRecordFile, IsReadAsItWasWritten) {
  for (const char* robot : {"mm2021", "classic", "half", "kerise", "beginner"})
    for (const char* mouse : {"flood", "certify"}) {
      if (test::briefly_sanitized && robot != std::string("kerise")) continue;
      const DriveRecordFile written = driven(mouse, test::ring(), robot, "thirtieth");
      const DriveRecordFile file = read(write_drive_record(written));
      EXPECT_EQ(file.record, written.record);
      EXPECT_EQ(file.maze, written.maze);
      EXPECT_EQ(file.maze_name, "ring");
      EXPECT_EQ(file.mouse, mouse);
      EXPECT_EQ(file.model->robot.name, robot);
      EXPECT_EQ(file.model->tables.hash, written.model->tables.hash);
      EXPECT_EQ(file.model->search, written.model->search);
      EXPECT_EQ(file.tables_hash, written.model->tables.hash);
      EXPECT_EQ(file.rules.name, "thirtieth");
      EXPECT_EQ(file.rules.maze_time_divisor, 30);
      EXPECT_EQ(file.rules.time_limit, written.rules.time_limit);
      EXPECT_EQ(file.recorded_score, written.recorded_score);
      EXPECT_TRUE(file.ended);
      EXPECT_EQ(replay(file), "");
    }
}

TEST(DriveRecordFile, HoldsDashes) {
  Robot robot = find_robot("mm2021").robot;
  robot.known_speed = 600.0;
  robot.known_acceleration = 5000.0;
  Rng rng(23);
  std::size_t dashes = 0;
  for (int round = 0; round < test::tenth(12); ++round) {
    DriveRecordFile written = driven("certify");
    written.maze = test::any_maze(rng, 12);
    written.model = std::make_shared<DriveModel>(make_drive_model(robot));
    const DriveBound bound = drive_bound_of(*written.maze, written.rules, *written.model);
    for (const BuiltinMouse* entry : builtin_mice())
      if (entry->name == "certify") {
        const auto mouse =
            entry->drive(brief(*written.maze, written.rules, *written.model, 1), Settings(entry->parameters));
        written.record = drive(*written.maze, written.rules, *written.model, *mouse);
      }
    const DriveScore result = score(written.record, written.rules);
    if (result.best) {
      written.recorded_score = result.runs[*result.best];
      EXPECT_LE(bound.score, written.recorded_score->value);
    }
    const DriveRecordFile file = read(write_drive_record(written));
    EXPECT_EQ(file.record, written.record);
    EXPECT_EQ(file.model->search, written.model->search);
    EXPECT_EQ(replay(file), "");
    for (const DriveRun& run : file.record.runs)
      for (const SearchMove& move : run.moves) dashes += move.action.movement > 1 ? 1 : 0;
  }
  EXPECT_GT(dashes, 0U);
}

TEST(DriveRecordFile, MayBreakOff) {
  const std::string whole = good();
  for (std::size_t end = whole.find('\n') + 1; end < whole.rfind("{\"outcome"); end += 97) {
    SCOPED_TRACE(end);
    const DriveRecordFile file = read(whole.substr(0, end));
    EXPECT_FALSE(file.ended);
    EXPECT_EQ(replay(file), "");
  }
}

TEST(DriveRecordFile, ThatIsNoneIsRefusedWithItsLine) {
  EXPECT_THAT(problem("").reason, HasSubstr("empty"));
  EXPECT_THAT(problem("{").reason, HasSubstr("JSON"));
  EXPECT_THAT(problem(changed(good(), "drive record", "record")).reason, Says("header", "seconds"));
  EXPECT_THAT(problem(changed(good(), "\"format\":1", "\"format\":2")).reason, Says("format", "1", "version"));
  EXPECT_THAT(problem(changed(good(), "\"robot\":{\"name\"", "\"robot\":{\"nome\"")).reason,
              Says("'robot.name'", "missing"));
  EXPECT_THAT(problem(changed(good(), "\"straight.speed\":1500", "\"straight.speed\":-5")).reason,
              Says("'robot'", "'straight.speed'", "-5", "50 to 20000 mm/s"));
  EXPECT_THAT(problem(changed(good(), "\"straight.speed\"", "\"straight speed\"")).reason,
              Says("'robot.parameters'", "no robot"));
  EXPECT_THAT(problem(changed(good(), "\"most_runs\":5", "\"most_runs\":0")).reason,
              Says("'rules.most_runs'", "1 to 100"));
  EXPECT_THAT(problem(good() + good()).reason, HasSubstr("end of the record"));
  EXPECT_THAT(problem(changed(good(), "\"run\":\"search\"", "\"run\":\"stroll\"")),
              ProblemAt(2, 1, "run", "search, home, speed"));
  EXPECT_THAT(problem(changed(good(), "{\"move\":[0,1]", "{\"move\":[0,33]")), ProblemAt(3, 1, "'move'", "0 to 32"));
  EXPECT_THAT(problem(changed(good(), "{\"move\"", "{\"love\"")).reason, Says("belong", "seconds"));
  EXPECT_THAT(problem(changed(good(), "\"piece\":\"R90\"", "\"piece\":\"R91\"")).reason,
              Says("piece", "straight", "turn", "speed"));
  EXPECT_THAT(problem(changed(good(), "\"outcome\":\"finished\"", "\"outcome\":\"lost\"")).reason,
              Says("'outcome'", "'lost'", "version"));
}

TEST(DriveRecordFile, WithWallsOfAnotherMazeIsRefused) {
  EXPECT_THAT(problem(changed(good(), "{\"wall\":[0,0,\"north\"]", "{\"wall\":[0,2,\"north\"]")).reason,
              Says("wall", "inner", "north or east"));
  EXPECT_THAT(problem(changed(good(), "\"north\":[\"1\",\"0\",\"0\"]", "\"north\":[\"1\",\"0\",\"1\"]")).reason,
              Says("'open'", "walls", "maze"));
  EXPECT_THAT(problem(changed(good(), "\"north\":[\"1\",\"0\",\"0\"]", "\"north\":[\"1\",\"0\"]")).reason,
              Says("'open'", "2 rows", "3"));
}

TEST(DriveRecordFile, ThatDoesNotFitItsMazeIsToldOf) {
  DriveRecordFile other = read(good());
  ++other.tables_hash;
  EXPECT_THAT(replay(other), Says("tables", "robot", "hash"));
  EXPECT_THAT(
      disagreement("\"until\":300000", "\"until\":300001"),
      SaysAt("run 1 (search): move 1", "(0,0) heading north", "(0,1) heading north", "0.300001 s", "0.300000 s"));
  EXPECT_THAT(disagreement("\"known\":null", "\"known\":5"), SaysAt("run 1 (search)", "known route", "0.000005 s"));
  EXPECT_THAT(disagreement("\"north\":[\"1\",\"0\",\"0\"]", "\"north\":[\"0\",\"0\",\"0\"]"),
              SaysAt("run 1 (search)", "0 open and 1 closed walls", "1 and 1"));
  EXPECT_THAT(disagreement("\"gate_out\":300000", "\"gate_out\":300001"),
              SaysAt("run 1 (search)", "start at 0.300001 s", "0.300000 s"));
  EXPECT_THAT(disagreement("\"open\":true,\"time\":0}", "\"open\":false,\"time\":0}"),
              SaysAt("wall 1", "north side of (0,0) closed", "north side of (0,0) open"));
  EXPECT_THAT(disagreement("\"score\":{\"value\":", "\"score\":{\"value\":1"),
              Says("score", "1.707515 s", "0.707515 s"));
}

TEST(DriveRecordFile, WithAWrongRouteIsToldOf) {
  EXPECT_THAT(disagreement("\"piece\":\"S2\"", "\"piece\":\"S4\""), HasSubstr("recorded end"));
  EXPECT_THAT(disagreement("{\"piece\":\"R90\"", "{\"piece\":\"L90\""), HasSubstr("recorded end"));
}

TEST(DriveRecordFile, IsRefusedWithAnotherWorldOrModel) {
  EXPECT_THAT(problem(changed(good(), "\"world\":\"seconds\"", "\"world\":\"strides\"")).reason,
              Says("world", "seconds"));
  EXPECT_THAT(problem(changed(good(), "\"model\":\"fixed\"", "\"model\":\"classes\"")).reason,
              Says("model", "'fixed'"));
}

/// The same run, so much later.
DriveRun later(DriveRun run, MazeTime by) {
  run.begin += by;
  run.end += by;
  for (auto* moment : {&run.gate_out, &run.gate_in, &run.centre})
    if (*moment) **moment += by;
  for (SearchMove& move : run.moves) {
    move.begin += by;
    move.end += by;
  }
  return run;
}

void score_again(DriveRecordFile& file) {
  const DriveScore result = score(file.record, file.rules);
  file.recorded_score = result.best ? std::optional(result.runs[*result.best]) : std::nullopt;
}

/// The record of a mouse that does so in the ring, under rules with that much time.
DriveRecordFile scripted(std::vector<Action> script, MazeTime time_limit) {
  DriveRecordFile file = driven("certify");
  file.rules.time_limit = time_limit;
  test::Scripted mouse(std::move(script));
  file.record = drive(*file.maze, file.rules, *file.model, mouse);
  score_again(file);
  return file;
}

/// To the edge of the goal of the ring, in 1,374 ms.
std::vector<Action> to_goal(const Action& then) {
  const Action on = Action::step(0, 1), right = Action::step(90, 1);
  return {on, on, right, on, right, then};
}

/// A search, the way home, and a speed run.
DriveRecordFile three_runs() {
  DriveRecordFile file = driven("certify");
  EXPECT_EQ(file.record.runs.size(), 3U);
  return file;
}

TEST(DriveRecordReplay, BeginsWithASearch) {
  DriveRecordFile file = three_runs();
  file.record.runs.erase(file.record.runs.begin());
  EXPECT_THAT(replay(file), SaysAt("run 1 (home)", "first run", "search"));
  file.record.runs.erase(file.record.runs.begin());
  EXPECT_THAT(replay(file), SaysAt("run 1 (speed)", "first run", "search"));
}

TEST(DriveRecordReplay, LetsNoRunBeginAtTheStartWhereTheMouseIsNot) {
  DriveRecordFile file = three_runs();
  auto& runs = file.record.runs;
  const DriveRun search = runs[0], fast = runs[2];
  runs = {search, later(fast, search.end - fast.begin)};
  EXPECT_THAT(replay(file), SaysAt("run 2 (speed)", "begins at the start"));
  runs = {search, later(search, search.end)};
  EXPECT_THAT(replay(file), SaysAt("run 2 (search)", "begins at the start"));
}

TEST(DriveRecordReplay, LetsNoMouseDriveBeforeAGoalWasEntered) {
  DriveRecordFile file = three_runs();
  auto& runs = file.record.runs;
  DriveRun search = runs[0];
  const DriveRun home = runs[1], fast = runs[2];
  search.moves.erase(search.moves.begin() + 2, search.moves.end());
  search.end = search.moves.back().end;
  search.gate_in = search.centre = std::nullopt;
  runs = {search, later(home, search.end - home.begin)};
  EXPECT_THAT(replay(file), SaysAt("run 2 (home)", "before a goal"));
  // From the start, which it has not left.
  search.moves.clear();
  search.end = search.begin;
  search.gate_out = std::nullopt;
  runs = {search, later(fast, -fast.begin)};
  EXPECT_THAT(replay(file), SaysAt("run 2 (speed)", "before a goal"));
}

TEST(DriveRecordReplay, CountsTheRunsThatBeginAtTheStart) {
  DriveRecordFile file = three_runs();
  auto& runs = file.record.runs;
  file.rules.most_runs = 2;
  EXPECT_EQ(replay(file), "");
  file.rules.most_runs = 1;
  EXPECT_THAT(replay(file), SaysAt("run 3 (speed)", "rules", "1 run "));
  // And once more: it is carried to the start.
  runs.push_back(later(runs[2], runs[2].end - runs[2].begin));
  file.rules.most_runs = 3;
  EXPECT_EQ(replay(file), "");
  file.rules.most_runs = 2;
  EXPECT_THAT(replay(file), SaysAt("run 4 (speed)", "rules", "2 runs "));
  file.rules.most_runs = 3;
  runs[3] = later(runs[3], 1);
  EXPECT_THAT(replay(file), SaysAt("run 4 (speed)", "beginning at"));
}

TEST(DriveRecordReplay, LetsNoRunBeginAfterTheTime) {
  DriveRecordFile file = three_runs();
  for (const std::size_t run : {std::size_t{1}, std::size_t{2}}) {
    file.rules.time_limit = file.record.runs[run].begin;
    score_again(file);
    EXPECT_THAT(replay(file), run == 1 ? SaysAt("run 2 (home)", "after the time", "1.374000 s")
                                       : SaysAt("run 3 (speed)", "after the time", "8.748000 s"));
  }
  // Just in time it may begin, though it does not count.
  ++file.rules.time_limit;
  score_again(file);
  EXPECT_EQ(file.recorded_score->run, 0U);
  EXPECT_EQ(replay(file), "");
}

TEST(DriveRecordReplay, WantsTheFastestKnownRoute) {
  // Flood finds the way along the middle row; only certify looks at the upper row, which makes a diagonal the faster
  // way.
  const Maze maze = test::drawn(R"(
    o---o---o---o---o
    |             G |
    o   o   o---o   o
    |               |
    o   o   o   o   o
    | S |       |   |
    o---o---o---o---o
  )");
  DriveRecordFile file = driven("certify", maze);
  ASSERT_EQ(replay(file), "");
  ASSERT_EQ(file.record.runs.size(), 3U);
  DriveRun& fast = file.record.runs[2];
  const DriveRoute slower = driven("flood", maze).record.runs.back().route;
  ASSERT_GT(slower.time, fast.route.time);
  ASSERT_LT(slower.time, no_time);
  const Pose start = {maze.start(), maze.start_heading()};
  ASSERT_EQ(check_route(slower, start, maze.size(), fast.open, maze.goals(), *file.model), "");
  fast.route = slower;
  set_gates(fast, maze, *file.model);
  fast.end = fast.begin + slower.time;
  score_again(file);
  EXPECT_THAT(replay(file), SaysAt("run 3 (speed)", "0.904562 s", "fastest", "0.789001 s"));
  // Nor does it help to say that no faster one was known.
  fast.known = slower.time;
  EXPECT_THAT(replay(file), SaysAt("run 3 (speed)", "known route", "0.904562 s"));
}

TEST(DriveRecordReplay, KnowsWhereASearchEndsInTheMiddleOfAGoal) {
  DriveRecordFile file = three_runs();
  file.record.runs[0].centre.reset();
  EXPECT_THAT(replay(file), SaysAt("run 1 (search)", "start at 0.300000 s", "goal at 1.374000 s", "centre at never",
                                   "0.300000 s, 1.374000 s and 1.674000 s"));
  // Not where the time ends at the edge of the goal, or where the mouse gives up there.
  for (DriveRecordFile cut : {scripted(to_goal(Action::reset()), 1'374'000),
                              scripted(to_goal(Action::forfeit(ForfeitReason::no_route)), 100'000'000)}) {
    ASSERT_EQ(cut.record.runs.size(), 1U);
    EXPECT_FALSE(cut.record.runs[0].centre);
    EXPECT_EQ(replay(cut), "");
    cut.record.runs[0].centre = 1'674'000;
    EXPECT_THAT(replay(cut), Says("centre at 1.674000 s", "0.300000 s, 1.374000 s and never"));
  }
}

TEST(DriveRecordFile, MayHaveTheNamesOfEarlierVersions) {
  const DriveRecordFile file = scripted(to_goal(Action::forfeit(ForfeitReason::no_route)), 100'000'000);
  const std::string text = changed(write_drive_record(file), "\"reason\":\"no route\"", "\"reason\":\"no way\"");
  EXPECT_EQ(read(text).record.reason, ForfeitReason::no_route);
  const std::string runs = write_drive_record(three_runs());
  EXPECT_EQ(read(changed(runs, "\"run\":\"speed\"", "\"run\":\"fast\"")).record, three_runs().record);
  EXPECT_EQ(read(changed(runs, "\"possible\":", "\"hoped\":")).record, three_runs().record);
}

TEST(DriveRecordReplay, ComparesAllPartsOfTheScore) {
  const DriveRecordFile file = three_runs();
  const auto said = [&](auto change) {
    DriveRecordFile other = file;
    change(*other.recorded_score);
    return replay(other);
  };
  const auto parts = HasSubstr("different parts");
  EXPECT_THAT(said([](DriveRunScore& score) { score.run = 0; }), parts);
  EXPECT_THAT(said([](DriveRunScore& score) { ++*score.gate_to_gate; }), parts);
  EXPECT_THAT(said([](DriveRunScore& score) { score.gate_to_gate.reset(); }), parts);
  EXPECT_THAT(said([](DriveRunScore& score) { ++*score.rest_to_centre; }), parts);
  EXPECT_THAT(said([](DriveRunScore& score) { score.rest_to_centre.reset(); }), parts);
  EXPECT_THAT(said([](DriveRunScore& score) { ++score.maze_time; }), parts);
  EXPECT_THAT(said([](DriveRunScore& score) { ++score.bonus; }), parts);
  EXPECT_THAT(said([](DriveRunScore& score) { score.value = 1'000'000; }),
              AllOf(Says("score", "1.000000 s", "0.707515 s"), Not(parts)));
  DriveRecordFile none = file;
  none.recorded_score.reset();
  EXPECT_THAT(replay(none), AllOf(Says("score", "none", "0.707515 s"), Not(parts)));
}

TEST(DriveRecordReplay, ComparesTheOutcome) {
  DriveRecordFile file = three_runs();
  file.record.outcome = DriveOutcome::out_of_time;
  EXPECT_THAT(replay(file), Says("'out of time'", "a run", "goal"));
  DriveRecordFile late = scripted(to_goal(Action::reset()), 1'000'000);
  ASSERT_EQ(late.record.outcome, DriveOutcome::out_of_time);
  EXPECT_EQ(replay(late), "");
  late.record.outcome = DriveOutcome::finished;
  EXPECT_THAT(replay(late), Says("'finished'", "no run", "goal"));
}

TEST(DriveRecordFile, HasASummary) {
  const DriveRecordFile file = driven("flood");
  const std::string summary = summary_of(file);
  EXPECT_THAT(
      summary,
      StartsWith("run           begin s     end s    gates   centre    known possible\n  1  search     0.000 "));
  EXPECT_THAT(summary, HasSubstr("\nflood in ring, mm2021, all-japan: "));
  EXPECT_THAT(summary, HasSubstr(" s gate to gate in run "));
}

TEST(DriveRecordReplay, TellsOfAWayHomeThatStopsBeforeTheStart) {
  DriveRecordFile file = driven("flood");
  ASSERT_EQ(file.record.runs.size(), 3U);
  DriveRun& home = file.record.runs[1];
  file.record.runs.resize(2);
  home.moves.pop_back();
  home.end = home.moves.back().end;
  EXPECT_THAT(replay(file), SaysAt("run 2 (home)", "end at rest"));
}

TEST(DriveRecordReplay, TellsOfAMoveAfterTheTime) {
  DriveRecordFile file = driven("flood");
  file.rules.time_limit = file.record.runs[0].moves[1].begin;
  EXPECT_THAT(replay(file), SaysAt("run 1 (search): move 2", "after the time", "0.300000 s"));
}

}  // namespace
}  // namespace labmouse
