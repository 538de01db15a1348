// What a mouse says of walls is as sure as it is right.
#include "labmouse/controller/wall_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/body/beams.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/controller/driven.hpp"
#include "tests/controller/robots.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

const Hardware& hardware() { return *test::kerise().robot.hardware; }
constexpr double cell = 90.0;

/// A wall to the left and none to the right.
const Maze& half_open() {
  static const Maze maze = test::drawn(R"(
    o---o---o---o
    |   |       |
    o   o   o   o
    |   |       |
    o   o   o   o
    | S |     G |
    o---o---o---o
  )");
  return maze;
}

/// The evidence of a mouse that passes the middle cell northwards, really so far aside and ahead of where it believes
/// to be, and as sure of its place as so many mm and a share of its angle.
/// `turned`: by how much it points to the left of the passage, as it knows.
WallEvidence passing(double aside, double ahead, double sure, Hardware book = hardware(), double turned = 0.0) {
  const Field field(half_open(), cell);
  const RobotSample robot_sample(book, no_errors, half_open().size(), 1);
  const Beams beams(field, book.sensors, robot_sample);
  const Direction points = direction_of(3.14159265358979 / 2.0 + turned);
  book.variation.placement = sure / 2.0;
  book.variation.placement_turn = 1e-6;
  WallReader reader(book, cell);
  reader.begin({{1, 1}, Heading::north});
  Estimator estimator(book, cell, 0.2);
  for (double y = 60.0; y < 110.0; y += 0.33) {
    const Position believed = {135.0, y}, truth = {135.0 + aside, y + ahead};
    estimator.put(believed, points);
    Sense sense;
    for (std::size_t beam = 0; beam < book.sensors.infrared.size(); ++beam)
      sense.infrared[beam] = static_cast<std::int16_t>(beams.level(beam, truth, points) + 0.5);
    for (std::size_t i = 0; i < book.sensors.rangers.size(); ++i)
      sense.ranges[i] = {static_cast<std::uint16_t>(beams.range(i, truth, points) + 0.5), true};
    reader.read(sense, estimator.estimate());
  }
  return reader.evidence(estimator.estimate());
}

TEST(WallReader, SeesWallsBesideItByToFSensors) {
  Hardware book = hardware();
  book.sensors.infrared.clear();
  book.sensors.rangers = {{{12.0, 12.0, 1.2}, 255.0, 11.0}, {{12.0, -12.0, -1.2}, 255.0, 11.0}};
  const WallEvidence evidence = passing(0.0, 0.0, 1.0, book);
  EXPECT_GT(evidence.left, 4 * evidence_a_nat);
  EXPECT_LT(evidence.right, -4 * evidence_a_nat);
}

/// Sensors at 45 degrees see walls also where the mouse points a little aside of the passage.
TEST(WallReader, SeesWallsByDiagonalSensors) {
  Hardware book = hardware();
  book.sensors.rangers.clear();
  book.sensors.infrared = {{{12.0, -12.0, -0.785}, 700.0, 12.9, 3650.0, 5.0},
                           {{12.0, 12.0, 0.785}, 700.0, 12.9, 3650.0, 5.0}};
  for (const double turned : {-0.1, 0.0, 0.1}) {
    const WallEvidence evidence = passing(0.0, 0.0, 1.0, book, turned);
    EXPECT_GT(evidence.left, 2 * evidence_a_nat) << turned;
    EXPECT_LT(evidence.right, -2 * evidence_a_nat) << turned;
  }
}

TEST(Views, CountManySensorsOfASideAsTwo) {
  const Infrared left = {{12.0, 12.0, 1.1}, 700.0, 12.9, 3650.0, 5.0},
                 ahead = {{20.0, 0.0, 0.0}, 700.0, 12.9, 3650.0, 5.0};
  const Views views({left, left, ahead, left, left}, cell);
  EXPECT_EQ(views.share_of(0), 0.5);
  EXPECT_EQ(views.share_of(2), 1.0);
}

TEST(WallReader, IsSureWhereItIsInTheMiddle) {
  const WallEvidence evidence = passing(0.0, 0.0, 1.0);
  EXPECT_EQ(evidence.left, 8 * evidence_a_nat) << "it says no more than that";
  EXPECT_EQ(evidence.right, -8 * evidence_a_nat);
}

TEST(WallReader, IsRightWhereItIsAFewMmAside) {
  for (const double aside : {-8.0, -4.0, 4.0, 8.0}) {
    const WallEvidence evidence = passing(aside, 0.0, 4.0);
    EXPECT_GT(evidence.left, 3 * evidence_a_nat) << aside;
    EXPECT_LT(evidence.right, -3 * evidence_a_nat) << aside;
  }
}

/// A wall that reads as a post would: the mouse is 20 mm farther from it than it believes. Nothing speaks for either,
/// to a mouse that may be that far off; one that is sure of its place takes it for none.
TEST(WallReader, IsNotSureWhereTheMouseIsNotSureOfItsPlace) {
  const WallEvidence sure = passing(20.0, 0.0, 0.5), unsure = passing(20.0, 0.0, 20.0);
  EXPECT_LT(std::abs(unsure.left), std::abs(sure.left));
  EXPECT_LT(std::abs(unsure.left), 4 * evidence_a_nat);
}

TEST(WallReader, IsLessSureTheLessItKnowsOfItsPlace) {
  int before = 1000;
  for (const double sure : {6.0, 12.0, 25.0}) {
    const int now = passing(10.0, 0.0, sure).left;
    EXPECT_LE(now, before) << sure;
    before = now;
  }
  EXPECT_LT(before, 8 * evidence_a_nat);
}

/// What the ranger says of a wall ahead that is 40 mm farther than it should be, to a mouse as sure of its place as
/// that.
Evidence ranging(double sure) {
  Hardware book = hardware();
  book.variation.placement = sure / 2.0;
  WallReader reader(book, cell);
  reader.begin({{1, 1}, Heading::north});
  Estimator estimator(book, cell, 0.2);
  // Too far for infrared to count.
  constexpr double far = 1.15 * cell;
  estimator.put({135.0, 2.0 * cell - half_wall_of(cell) - book.sensors.rangers[0].beam.ahead - far}, {1.0, 0.0});
  Sense sense;
  sense.ranges[0] = {static_cast<std::uint16_t>(far + 40.0), true};
  reader.read(sense, estimator.estimate());
  return reader.evidence(estimator.estimate()).ahead;
}

TEST(WallReader, TakesAWallThatIsFartherForOneTheLessItKnowsOfItsPlace) {
  EXPECT_GT(ranging(20.0), ranging(0.5));
  EXPECT_GT(ranging(10.0), ranging(0.5));
}

TEST(WallReader, SaysNothingOfACellThatItHasNotSeen) {
  WallReader reader(hardware(), cell);
  Estimator estimator(hardware(), cell, 0.2);
  estimator.put({135.0, 135.0}, {1.0, 0.0});
  EXPECT_EQ(reader.evidence(estimator.estimate()), WallEvidence{});
  reader.begin({{1, 1}, Heading::north});
  EXPECT_EQ(reader.evidence(estimator.estimate()), WallEvidence{});
}

/// A wall that reads as a post would, seen as less and less of it: there is no evidence of less than a nat, and there
/// is some of hardly more.
TEST(WallReader, SaysNothingWhereItWouldSayLittle) {
  int silent = 0, least = 1000;
  for (double aside = 0.0; aside < 30.0; aside += 0.25) {
    const int left = std::abs(passing(aside, 0.0, 20.0).left);
    silent += left == 0 ? 1 : 0;
    if (left != 0) least = std::min(least, left);
  }
  EXPECT_GT(silent, 2);
  EXPECT_GE(least, evidence_a_nat);
  EXPECT_LT(least, evidence_a_nat + evidence_a_nat / 2);
}

TEST(WallReader, ForgetsTheCellBefore) {
  const WallEvidence evidence = passing(0.0, 0.0, 1.0);
  ASSERT_NE(evidence, WallEvidence{});
  WallReader reader(hardware(), cell);
  Estimator estimator(hardware(), cell, 0.2);
  estimator.put({135.0, 90.0}, {1.0, 0.0});
  reader.begin({{1, 1}, Heading::north});
  Sense sense;
  sense.infrared = {700, 0, 700, 0};
  for (int i = 0; i < 50; ++i) reader.read(sense, estimator.estimate());
  ASSERT_NE(reader.evidence(estimator.estimate()), WallEvidence{});
  reader.begin({{1, 2}, Heading::north});
  EXPECT_EQ(reader.evidence(estimator.estimate()), WallEvidence{});
}

/// Among walls for which the evidence is as strong, how many are read wrongly.
struct Tally {
  int all = 0, wrong = 0;
};
using Tallies = std::array<Tally, 9>;  ///< by whole nats

void add(Tallies& tallies, Evidence evidence, bool stands) {
  Tally& tally = tallies[static_cast<std::size_t>(std::abs(evidence) / evidence_a_nat)];
  ++tally.all;
  tally.wrong += (evidence > 0) != stands ? 1 : 0;
}

/// Of mice that wander in mazes of contests.
Tallies read_walls(const DriveModel& model, const ErrorScale& scale, int mazes) {
  Tallies tallies;
  for (int i = 0; i < mazes; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    test::Driven driven(contest_generator.make({{16, 16}, seed, 60}), model, scale, seed);
    Rng rng(seed);
    if (!driven.drive_on()) continue;
    for (int move = 0; move < 40; ++move) {
      const SearchPlace place = driven.controller().place();
      const std::array<int, 3> turns = {0, -90, 90};
      const int first = rng.below(3);
      Action step = Action::step(180, 1);
      for (int k = 0; k < 3; ++k) {
        const Action way = Action::step(turns[static_cast<std::size_t>((first + k) % 3)], 1);
        if (driven.maze().is_open(place.pose.cell, after_search(place, way).pose.heading)) step = way;
      }
      if (!driven.search(step)) break;
      const Pose pose = driven.controller().place().pose;
      const WallEvidence evidence = driven.controller().evidence();
      add(tallies, evidence.left, !driven.maze().is_open(pose.cell, left_of(pose.heading)));
      add(tallies, evidence.ahead, !driven.maze().is_open(pose.cell, pose.heading));
      add(tallies, evidence.right, !driven.maze().is_open(pose.cell, right_of(pose.heading)));
    }
  }
  return tallies;
}

TEST(Evidence, IsNeverSureAndWrongByTheErrorsThatItKnows) {
  LABMOUSE_SKIP_SANITIZED();
  for (const DriveModel* model : {&test::kerise(), &test::classic(), &test::beginner()}) {
    SCOPED_TRACE(model->robot.name);
    const Tallies tallies = read_walls(*model, {}, test::some_of(200));
    int all = 0, wrong = 0;
    for (std::size_t nats = 0; nats < tallies.size(); ++nats) {
      all += tallies[nats].all;
      wrong += tallies[nats].wrong;
      if (nats >= 6) {
        EXPECT_LE(tallies[nats].wrong, 2e-4 * tallies[nats].all) << nats << " nats";
      }
    }
    ASSERT_GT(all, 1000);
    EXPECT_LE(wrong, 1 + 5e-4 * all);
    const bool ranges = !model->robot.hardware->sensors.rangers.empty();
    EXPECT_GT(tallies[8].all, (ranges ? 0.9 : 0.8) * all) << "and it is nearly always sure";
  }
}

/// At a contest, whose variation the reader knows: of evidence of n nats, about one of e^n is wrong.
TEST(Evidence, IsWrongAsOftenAsItSays) {
  LABMOUSE_SKIP_SANITIZED();
  const Tallies tallies = read_walls(test::model_of("kerise"), {}, test::some_of(400));
  int all = 0, wrong = 0;
  for (std::size_t nats = 0; nats < tallies.size(); ++nats) {
    all += tallies[nats].all;
    wrong += tallies[nats].wrong;
    // Evidence is limited to 8 nats, but few readings deserve as many.
    const double expected = tallies[nats].all * std::exp(-std::min(6.0, static_cast<double>(nats)));
    EXPECT_LE(tallies[nats].wrong, 3.0 * expected + 3.0 * std::sqrt(expected) + 1.0) << nats << " nats";
  }
  EXPECT_GT(wrong, 0);
  EXPECT_LE(wrong, 0.03 * all);
}

/// Four times as many errors as it knows of: then it errs, and where it does it is less sure.
TEST(Evidence, IsWrongLessOftenTheSurerItIs) {
  LABMOUSE_SKIP_SANITIZED();
  const Tallies tallies = read_walls(test::kerise(), {.noise = 4.0, .variation = 4.0}, test::some_of(200));
  const auto share = [&](std::size_t from, std::size_t to) {
    Tally sum;
    for (std::size_t nats = from; nats < to; ++nats) {
      sum.all += tallies[nats].all;
      sum.wrong += tallies[nats].wrong;
    }
    return sum.all == 0 ? 0.0 : static_cast<double>(sum.wrong) / sum.all;
  };
  EXPECT_GT(share(0, 3), 2.0 * share(3, 8));
  EXPECT_GT(share(3, 8), 2.0 * share(8, 9));
}

}  // namespace
}  // namespace labmouse
