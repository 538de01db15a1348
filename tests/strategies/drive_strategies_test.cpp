// The mice that drive in seconds, in mazes of all kinds.
#include <gtest/gtest.h>

#include <algorithm>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/mouse/drive/drive_fields.hpp"
#include "labmouse/mouse/log_odds_map.hpp"
#include "labmouse/mouse/runs.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/counting_mouse.hpp"
#include "tests/strategies/mouse_name.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

struct SomeMaze {
  std::string name;
  Maze maze;
};

const std::vector<SomeMaze>& generated_mazes() {
  static const std::vector<SomeMaze> mazes = [] {
    std::vector<SomeMaze> made;
    Rng rng(17);
    for (int i = 0; i < test::some_of(160); ++i)
      made.push_back({"generated " + std::to_string(i), test::any_maze(rng, 20)});
    return made;
  }();
  return mazes;
}

const std::vector<SomeMaze>& real_mazes() {
  static const std::vector<SomeMaze> mazes = [] {
    std::vector<SomeMaze> read;
    const auto files = test::maze_files();
    for (std::size_t i = 0; i < files.size(); i += test::slowness)
      if (auto maze = test::maze_in_file(files[i]);
          maze && std::max(maze->size().width, maze->size().height) <= max_drive_side)
        read.push_back({files[i].filename(), std::move(*maze)});
    return read;
  }();
  return mazes;
}

DriveModel model_of(const Robot& robot) {
  DriveModel model = make_drive_model(robot);
  share_route_tables(model);
  return model;
}

const DriveModel& published() {
  static const DriveModel model = model_of(published_robot());
  return model;
}
const DriveModel& large() {
  static const DriveModel model = model_of(large_robot());
  return model;
}

const DriveModel& dashing() {
  static const DriveModel model = [] {
    Robot robot = published_robot();
    robot.known_speed = 900.0;
    return model_of(robot);
  }();
  return model;
}

DriveRules rules_of(int divisor, std::int64_t seconds = 3600) {
  DriveRules rules;
  rules.time_limit = seconds * 1'000'000;
  rules.maze_time_divisor = divisor;
  return rules;
}

std::unique_ptr<DrivingStrategy> make(const BuiltinMouse& mouse, const Maze& maze, const DriveRules& rules,
                                      const DriveModel& model) {
  return mouse.drive(brief(maze, rules, model, 1), Settings(mouse.parameters));
}

DriveRecord contest(const BuiltinMouse& mouse, const Maze& maze, const DriveRules& rules, const DriveModel& model) {
  return drive(maze, rules, model, *make(mouse, maze, rules, model));
}

DriveTime fastest(const Maze& maze, const DriveModel& model) {
  FastestRoutes routes(maze.size(), model.tables);
  routes.fill(maze.open_walls(), maze.goals());
  return routes.time_from({maze.start(), maze.start_heading()});
}

const DriveRun* last_run(const DriveRecord& record) {
  return record.runs.empty() || record.runs.back().kind != DriveRun::Kind::speed ? nullptr : &record.runs.back();
}

std::vector<const BuiltinMouse*> drivers() {
  std::vector<const BuiltinMouse*> mice;
  for (const BuiltinMouse* entry : all_mice())
    if (entry->drives()) mice.push_back(entry);
  return mice;
}

class EveryDriver : public testing::TestWithParam<const BuiltinMouse*> {
 protected:
  const BuiltinMouse& mouse() const { return *GetParam(); }

  /// The mouse comes to the goal and home, and then runs by a way that is there, wherever there is one. Where the only
  /// way that a search has found begins behind the start, or beside it, there is none: a run begins straight on.
  void expect_good_contests(const std::vector<SomeMaze>& mazes, const DriveRules& rules,
                            const DriveModel& model) const {
    for (const SomeMaze& maze : mazes) {
      SCOPED_TRACE(maze.name);
      const DriveRecord record = contest(mouse(), maze.maze, rules, model);
      const DriveTime best = fastest(maze.maze, model);
      if (record.outcome == DriveOutcome::forfeit) {
        EXPECT_EQ(record.reason, ForfeitReason::no_route);
        EXPECT_EQ(best, no_time);
        continue;
      }
      ASSERT_EQ(record.outcome, DriveOutcome::finished);
      const DriveRun* run = last_run(record);
      if (run == nullptr) {
        EXPECT_TRUE(best == no_time || (stops_at_once() && may_leave_sideways(maze.maze)));
        continue;
      }
      EXPECT_GE(run->route.time, best);
      WallSet walls = walls_needed_by(run->route, model.tables);
      EXPECT_TRUE((walls -= maze.maze.open_walls()).empty());
    }
  }

 private:
  bool stops_at_once() const { return mouse().name.starts_with("flood"); }
  static bool may_leave_sideways(const Maze& maze) {
    return std::any_of(all_headings.begin(), all_headings.end(), [&](Heading heading) {
      return heading != maze.start_heading() && maze.is_open(maze.start(), heading);
    });
  }
};

TEST_P(EveryDriver, NeverLosesItsWay) {
  for (const int divisor : {0, 30}) {
    expect_good_contests(generated_mazes(), rules_of(divisor), published());
    expect_good_contests(generated_mazes(), rules_of(divisor), large());
    expect_good_contests(generated_mazes(), rules_of(divisor), dashing());
  }
}

TEST_P(EveryDriver, NeverLosesItsWayInRealMazes) {
  if (real_mazes().empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  // Without a divisor the proofs below go through them.
  expect_good_contests(real_mazes(), rules_of(30), published());
}

TEST_P(EveryDriver, LooksAsFarAsItsSensorsReach) {
  for (const int sight : {2, 5, max_side}) {
    Robot robot = published_robot();
    robot.sight = sight;
    expect_good_contests(generated_mazes(), rules_of(30), make_drive_model(robot));
  }
}

TEST_P(EveryDriver, DashesThroughWhatItKnows) {
  const auto search_time_of = [](const DriveRecord& record, std::size_t& dashes) {
    MazeTime time = 0;
    for (const DriveRun& run : record.runs) {
      if (run.kind == DriveRun::Kind::speed) continue;
      time += run.end - run.begin;
      for (const SearchMove& move : run.moves) dashes += move.action.movement > 1 ? 1 : 0;
    }
    return time;
  };
  MazeTime slow = 0, fast = 0;
  std::size_t none = 0, dashes = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Maze maze = find_generator("depth-first")->make({{16, 16}, seed, 0});
    slow += search_time_of(contest(mouse(), maze, rules_of(0), published()), none);
    fast += search_time_of(contest(mouse(), maze, rules_of(0), dashing()), dashes);
  }
  EXPECT_EQ(none, 0U);
  EXPECT_GT(dashes, 0U);
  EXPECT_LT(fast, slow);
}

TEST_P(EveryDriver, GivesTheSameRecordAgain) {
  for (std::size_t i = 0; i < generated_mazes().size(); i += 10) {
    const Maze& maze = generated_mazes()[i].maze;
    EXPECT_EQ(contest(mouse(), maze, rules_of(30), published()), contest(mouse(), maze, rules_of(30), published()));
  }
}

TEST_P(EveryDriver, RunsInTimeWhereItKnowsARunInTime) {
  for (const SomeMaze& maze : generated_mazes())
    for (const int seconds : {60, 90, 150}) {
      SCOPED_TRACE(maze.name + " in " + std::to_string(seconds) + " s");
      const DriveRules rules = rules_of(0, seconds);
      const DriveRecord record = contest(mouse(), maze.maze, rules, published());
      if (record.outcome != DriveOutcome::finished) continue;
      // It entered the goal in the first quarter of the time, which leaves enough for pivots, a way home as long and a
      // run.
      const auto entered = record.runs.front().gate_in;
      if (!entered || *entered * 4 > rules.time_limit || fastest(maze.maze, published()) == no_time) continue;
      const DriveRun& last = record.runs.back();
      if (last.kind == DriveRun::Kind::home && last.known == no_time) continue;
      ASSERT_NE(last_run(record), nullptr);
      EXPECT_LE(last_run(record)->end, rules.time_limit);
    }
}

TEST(AriadneInSeconds, GoesByEachOfItsNumbersHoweverOdd) {
  const BuiltinMouse& ariadne = *find_mouse("ariadne");
  for (const Parameter& parameter : ariadne.parameters) {
    if (parameter.scope != ParameterScope::seconds) continue;
    SCOPED_TRACE(parameter.name);
    bool matters = false;
    for (const double value : {parameter.low, parameter.high})
      for (const int divisor : {0, 30})
        for (std::size_t i = 0; i < generated_mazes().size(); i += 9) {
          const Maze& maze = generated_mazes()[i].maze;
          const DriveRules rules = rules_of(divisor, 150);
          Settings settings(ariadne.parameters);
          settings.set(parameter.name, std::to_string(value));
          const auto mouse = ariadne.drive(brief(maze, rules, published(), 1), settings);
          const DriveRecord record = drive(maze, rules, published(), *mouse);
          EXPECT_TRUE(record.outcome != DriveOutcome::forfeit || record.reason == ForfeitReason::no_route);
          matters = matters || record != contest(ariadne, maze, rules, published());
        }
    EXPECT_TRUE(matters || test::slowness > 1);
  }
}

TEST(DriversThatGoHome, LookOnUntilAnotherStepWouldBeTooMuch) {
  LABMOUSE_SKIP_SANITIZED();
  MazeTime spare = 0;
  int late = 0;
  for (const SomeMaze& maze : generated_mazes())
    for (const int seconds : {30, 40, 45, 50, 60}) {
      const DriveRules rules = rules_of(0, seconds);
      const DriveRecord record = contest(*find_mouse("certify"), maze.maze, rules, published());
      const DriveRun* run = last_run(record);
      // Until nothing was left to look at, or time had run out before the goal.
      if (run == nullptr || run->known == run->possible || run->end > rules.time_limit) continue;
      spare += rules.time_limit - run->end;
      ++late;
    }
  ASSERT_GT(late, 4);
  EXPECT_LT(spare / late, 2 * published().search.back);
}

/// Robots of all kinds of searches and limits.
const std::vector<DriveModel>& all_kinds() {
  static const std::vector<DriveModel> models = [] {
    std::vector<DriveModel> made;
    for (const Robot& robot :
         {published_robot(), robot_of_speeds<1>(), robot_of_speeds<2>(), large_robot(), robot_of_speeds<8>(),
          grip_robot(), jerk_robot(), square_robot(), slow_robot(), unstopped_robot()})
      made.push_back(model_of(robot));
    return made;
  }();
  return models;
}

TEST_P(EveryDriver, TakesAllItsMemoryBeforeItDrives) {
  for (const DriveModel& model : all_kinds())
    for (std::size_t i = 0; i < generated_mazes().size(); i += 40) {
      const Maze& maze = generated_mazes()[i].maze;
      const auto strategy = make(mouse(), maze, rules_of(30, 100), model);
      test::CountingDriver counting(*strategy);
      drive(maze, rules_of(30, 100), model, counting);
      EXPECT_EQ(counting.allocations(), 0) << model.robot.name << " in " << generated_mazes()[i].name;
    }
}

TEST_P(EveryDriver, DrivesInMemoryThatIsGiven) {
  for (const DriveModel& model : all_kinds())
    for (std::size_t i = 0; i < generated_mazes().size(); i += 40) {
      const Maze& maze = generated_mazes()[i].maze;
      // Of exactly that many bytes, which hold anything before.
      const std::size_t bytes = DriveFields::bytes_for(maze.size(), model);
      std::unique_ptr<std::byte[]> memory(new std::byte[bytes]);
      std::fill(memory.get(), memory.get() + bytes, std::byte{0xa5});
      DriveFields fields(maze.size(), model, {memory.get(), bytes});
      Briefing briefing = brief(maze, rules_of(30), model, 1);
      briefing.drive.fields = &fields;
      const auto strategy = mouse().drive(briefing, Settings(mouse().parameters));
      EXPECT_EQ(drive(maze, rules_of(30), model, *strategy), contest(mouse(), maze, rules_of(30), model))
          << model.robot.name << " in " << generated_mazes()[i].name;
    }
}

/// Readings of a maze that is another one each time that one looks.
class Nonsense {
 public:
  explicit Nonsense(std::uint64_t seed) : rng_(seed) {}

  /// Of the walls about the place, or about the cell that a mouse has just come through, too.
  void read(LogOddsMap& log_odds, const Pose& pose) {
    for (const Heading side : {left_of(pose.heading), pose.heading, right_of(pose.heading)})
      static_cast<void>(log_odds.add(wall_at(pose.cell, side), rng_.below(129) - 64));
  }
  bool carries() { return rng_.below(50) == 0; }

 private:
  Rng rng_;
};

TEST_P(EveryDriver, StandsAnyReadings) {
  const Maze maze = generated_mazes().front().maze;
  const DriveRules rules = rules_of(30);
  const DriveModel& model = published();
  int turned = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test::some_of(2500)); ++seed) {
    Nonsense nonsense(seed);
    const auto strategy = make(mouse(), maze, rules, model);
    LogOddsMap log_odds(maze.size(), MapKind::log_odds);
    SearchPlace place = {{maze.start(), maze.start_heading()}, true};
    for (int decision = 0; decision < 400; ++decision) {
      nonsense.read(log_odds, place.pose);
      if (nonsense.carries()) {
        place = {{maze.start(), maze.start_heading()}, true};
        strategy->carried(1000 * decision);
        nonsense.read(log_odds, place.pose);
      }
      const Action action = strategy->consider(log_odds, place, 1000 * decision);
      if (action.kind == Action::Kind::reset) {
        strategy->carried(1000 * decision);
        place = {{maze.start(), maze.start_heading()}, true};
        continue;
      }
      if (action.kind == Action::Kind::forfeit) {
        ASSERT_EQ(action.reason, ForfeitReason::no_route) << seed << ' ' << decision;
        if (!log_odds.weaken_path(place.pose.cell, maze.goals()) &&
            !log_odds.weaken_path(place.pose.cell, CellSet::of(maze.start())))
          break;
        continue;
      }
      ASSERT_TRUE(is_search_step(place, action)) << seed << ' ' << decision;
      const SearchPlace next = after_search(place, action);
      for (Cell cell = place.pose.cell; cell != next.pose.cell; cell = neighbour(cell, next.pose.heading))
        ASSERT_TRUE(log_odds.view().open().contains(wall_at(cell, next.pose.heading))) << seed << ' ' << decision;
      place = next;
    }
    turned += log_odds.version();
  }
  EXPECT_GT(turned, 100);
}

INSTANTIATE_TEST_SUITE_P(BuiltinMice, EveryDriver, testing::ValuesIn(drivers()), test::mouse_name);

void expect_proofs(const BuiltinMouse& mouse, const std::vector<SomeMaze>& mazes, const DriveModel& model) {
  for (const SomeMaze& maze : mazes) {
    SCOPED_TRACE(maze.name);
    const DriveRecord record = contest(mouse, maze.maze, rules_of(0), model);
    const DriveRun* run = last_run(record);
    if (run == nullptr) {
      EXPECT_EQ(fastest(maze.maze, model), no_time);
      continue;
    }
    EXPECT_EQ(run->route.time, fastest(maze.maze, model));
    EXPECT_EQ(run->known, run->possible);
  }
}

TEST(Proof, MakesTheRunTheFastestThereIs) {
  for (const DriveModel* model : {&published(), &large()}) expect_proofs(certify_mouse, generated_mazes(), *model);
}

TEST(Proof, MakesTheRunTheFastestThereIsInRealMazes) {
  if (real_mazes().empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  std::vector<SomeMaze> fourth;
  for (std::size_t i = 0; i < real_mazes().size(); i += 4) fourth.push_back(real_mazes()[i]);
  expect_proofs(certify_mouse, test::sanitized ? fourth : real_mazes(), published());
  expect_proofs(certify_mouse, fourth, large());
}

/// Keeps the runs of certify beside it, and compares them with a plan from nothing at each decision.
class Replanning final : public ForwardingDriver {
 public:
  Replanning(DrivingStrategy& mouse, const Briefing& briefing)
      : ForwardingDriver(mouse),
        kept_fields_(DriveFields::in_own_memory(briefing.size, *briefing.drive.model)),
        new_fields_(DriveFields::in_own_memory(briefing.size, *briefing.drive.model)),
        new_(briefing),
        runs_(with(briefing, kept_fields_)) {
    new_.drive.fields = &new_fields_;
  }
  Action decide(const Sighting& seen) override {
    const Action action = mouse().decide(seen);
    kept_ += runs_.plan(knowledge()) ? 0 : 1;
    DriveRuns anew(new_);
    anew.plan(knowledge());
    EXPECT_EQ(runs_.optimistic_time(), anew.optimistic_time());
    EXPECT_EQ(runs_.unknown_walls(), anew.unknown_walls());
    return action;
  }
  int kept() const { return kept_; }

 private:
  static Briefing with(Briefing briefing, DriveFields& fields) {
    briefing.drive.fields = &fields;
    return briefing;
  }

  DriveFields kept_fields_, new_fields_;
  Briefing new_;
  DriveRuns runs_;
  int kept_ = 0;
};

TEST(DriveRuns, AreWhatAPlanFromNothingWouldBe) {
  for (const DriveModel* model : {&published(), &large()})
    for (std::size_t i = 0; i < generated_mazes().size(); i += 5) {
      SCOPED_TRACE(generated_mazes()[i].name);
      const Maze& maze = generated_mazes()[i].maze;
      const auto mouse = make(certify_mouse, maze, rules_of(0), *model);
      Replanning replanning(*mouse, brief(maze, rules_of(0), *model, 1));
      const DriveRecord record = drive(maze, rules_of(0), *model, replanning);
      EXPECT_TRUE(replanning.kept() > 0 || record.decisions < 20);
    }
}

TEST(DriversOfSeconds, SayWhenTheyPlanAnew) {
  const DriveRecord record = contest(certify_mouse, generated_mazes().front().maze, rules_of(0), published());
  int marked = 0;
  for (const DriveRun& run : record.runs)
    for (const SearchMove& move : run.moves) marked += move.replanned ? 1 : 0;
  EXPECT_GT(record.replanned, 0);
  // The last decision is a reset.
  EXPECT_GE(record.replanned, marked);
  EXPECT_LE(record.replanned, marked + 2);
}

/// Its own, beside the fields that it is given, and all together: bars for chips.
TEST(DriversOfSeconds, FitTheirMemory) {
  constexpr std::size_t kib = 1024;
  struct Bar {
    const DriveModel& model;
    std::size_t small, large;
  };
  Robot slower = large_robot();
  slower.speeds = 1;
  const DriveModel one = model_of(slower);
  slower.speeds = 2;
  const DriveModel two = model_of(slower);
  for (const Bar& bar : {Bar{published(), 64 * kib, 224 * kib}, Bar{one, 64 * kib, 224 * kib},
                         Bar{two, 256 * kib, 1024 * kib}, Bar{large(), 768 * kib, 3072 * kib}})
    for (const int side : {16, 32})
      for (const BuiltinMouse* mouse : {&flood_mouse, &certify_mouse, &ariadne_mouse}) {
        const Size size{side, side};
        const std::size_t fields = DriveFields::bytes_for(size, bar.model);
        std::unique_ptr<std::byte[]> memory(new std::byte[fields]);
        DriveFields given(size, bar.model, {memory.get(), fields});
        const Maze maze(MazeDraft(size, MazeDraft::Inside::open));
        Briefing briefing = brief(maze, rules_of(30), bar.model, 1);
        briefing.drive.fields = &given;
        const long before = test::allocated_bytes();
        const auto strategy = mouse->drive(briefing, Settings(mouse->parameters));
        const auto own = static_cast<std::size_t>(test::allocated_bytes() - before);
        const std::size_t bar_here = (side == 16 ? bar.small : bar.large) + (mouse == &ariadne_mouse ? 16 * kib : 0);
        EXPECT_LE(fields + own, bar_here) << mouse->name << " " << side << ": " << own << " bytes of its own";
      }
}

double mean_value(const BuiltinMouse& mouse, const DriveRules& rules) {
  double sum = 0;
  int count = 0;
  for (const SomeMaze& maze : real_mazes()) {
    if (maze.maze.size().width != 16) continue;
    const auto value = score(contest(mouse, maze.maze, rules, published()), rules).value();
    if (!value) continue;
    sum += static_cast<double>(*value) / 1e6;
    ++count;
  }
  return sum / count;
}

TEST(Ariadne, SearchesLessThanCertifyForRunsAlmostAsGood) {
  LABMOUSE_SKIP_SANITIZED();
  if (real_mazes().empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  double searches[2] = {}, runs[2] = {};
  for (const SomeMaze& maze : real_mazes()) {
    if (maze.maze.size().width != 16) continue;
    DriveRecord records[] = {contest(certify_mouse, maze.maze, rules_of(0), published()),
                             contest(ariadne_mouse, maze.maze, rules_of(0), published())};
    if (last_run(records[0]) == nullptr) continue;
    for (const int mouse : {0, 1}) {
      const DriveRun* run = last_run(records[mouse]);
      ASSERT_NE(run, nullptr) << maze.name;
      searches[mouse] += static_cast<double>(run->begin) / 1e6;
      runs[mouse] += static_cast<double>(run->route.time) / 1e6;
    }
  }
  EXPECT_LT(searches[1], 0.97 * searches[0]);
  EXPECT_LT(runs[1], 1.01 * runs[0]);
}

TEST(Ariadne, ScoresBestUnderAThirtieth) {
  if (real_mazes().empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  if (test::sanitized) GTEST_SKIP() << "a mean over many mazes is no matter of sanitizers";
  const DriveRules rules = rules_of(30, 600);
  const double ariadne = mean_value(ariadne_mouse, rules);
  EXPECT_LT(ariadne, mean_value(flood_return_mouse, rules));
  EXPECT_LT(ariadne, mean_value(certify_mouse, rules));
}

}  // namespace
}  // namespace labmouse
