// The estimator of docs/how-to/own-controller.md drives with our other parts, and is worse than ours.
#include "own_part.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "labmouse/contest/code_contest.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/external/external_parts.hpp"
#include "labmouse/lab/mice/controller_lines.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

using test::ring;

struct Contest {
  DriveRules rules = find_rules("all-japan").rules;
  DriveModel model = find_robot("kerise").model;
  PhysicalConditions conditions;

  Contest() {
    share_route_tables(model);
    conditions.trace_every = 10;
  }
  std::unique_ptr<DrivingStrategy> strategy() const {
    Briefing briefing = brief(ring(), rules, model, 1);
    briefing.sight = 1;
    const BuiltinMouse& entry = *find_mouse("flood-return");
    return entry.drive(briefing, Settings(entry.parameters));
  }
};

/// How far from where it was it ever believed to be, in mm.
double farthest(const PhysicalRecord& record) {
  double most = 0.0;
  for (const TracePoint& point : record.trace) {
    const Position off = point.estimate->position - point.truth.position;
    most = std::max({most, std::abs(off.x), std::abs(off.y)});
  }
  return most;
}

TEST(DeadReckoning, DrivesAndLosesItsPosition) {
  const Contest contest;
  const auto own = contest.strategy(), other = contest.strategy();
  const PhysicalRecord ours = drive_physically(ring(), contest.rules, contest.model, contest.conditions, 1, *other);
  const PhysicalRecord reckoned =
      drive_by_dead_reckoning(ring(), contest.rules, contest.model, contest.conditions, *own);
  ASSERT_FALSE(reckoned.drive.runs.empty());
  EXPECT_FALSE(reckoned.drive.runs.front().moves.empty());
  EXPECT_GT(farthest(reckoned), 2.0 * farthest(ours));
}

/// templates/estimator.py does the same in another process: not a bit of the contest differs.
TEST(DeadReckoning, IsTheSameAsAProgram) {
  Contest contest;
  contest.rules.time_limit = 20'000'000;
  const auto own = contest.strategy(), other = contest.strategy();
  const PhysicalRecord in_cpp = drive_by_dead_reckoning(ring(), contest.rules, contest.model, contest.conditions, *own);
  Launch launch;
  launch.words = {LABMOUSE_PYTHON, LABMOUSE_ESTIMATOR};
  launch.limits.silence = launch.limits.contest = std::chrono::minutes(5);
  ExternalParts program(
      launch, controller_lines(controller_briefing(ring(), contest.rules, contest.model, contest.conditions, 1)));
  const PhysicalRecord in_python =
      drive_physically(ring(), contest.rules, contest.model, contest.conditions, 1, *other, program.parts());
  EXPECT_EQ(program.last_words(), "");
  EXPECT_GT(in_cpp.trace.size(), 500U);
  EXPECT_EQ(in_python, in_cpp);
}

}  // namespace
}  // namespace labmouse
