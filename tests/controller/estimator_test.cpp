// Where a mouse believes to be: exact without noise, and as sure as it is right with it.
#include "labmouse/controller/estimator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "labmouse/functions/whole.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/body/plain_mouse.hpp"
#include "tests/controller/driven.hpp"
#include "tests/controller/robots.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

const Hardware& hardware() { return *test::kerise().robot.hardware; }

/// A mouse on a floor without walls, driven by duties alone, and what it believes.
class OnAFloor {
 public:
  explicit OnAFloor(const Hardware& built, const ErrorScale& level, std::uint64_t seed = 1)
      : OnAFloor(built, hardware(), level, seed) {}
  /// `known`: the hardware that the estimator expects; it must outlive this.
  OnAFloor(const Hardware& built, const Hardware& known, const ErrorScale& level, std::uint64_t seed)
      : body_(test::hall(7), 1000.0, built, level, seed), estimator_(known, 90.0, 0.2) {
    body_.put({3500.0, 3500.0}, 0.4);
    estimator_.put({3500.0, 3500.0}, direction_of(0.4));
  }

  void drive(int ticks, double left, double right) {
    for (int i = 0; i < ticks; ++i) {
      estimator_.predict(body_.sense());
      body_.step({static_cast<float>(left), static_cast<float>(right)});
    }
    estimator_.predict(body_.sense());
  }
  double error() const {
    const Position off = estimator_.position() - body_.motion().position;
    return std::hypot(off.x, off.y);
  }
  double angle_error() const {
    const Direction &believed = estimator_.ahead(), &truth = body_.motion().ahead;
    return believed.sine * truth.cosine - believed.cosine * truth.sine;
  }
  const Body& body() const { return body_; }
  Estimator& estimator() { return estimator_; }

 private:
  test::BodyInAMaze body_;
  Estimator estimator_;
};

TEST(Estimator, FollowsAMouseWithoutNoise) {
  OnAFloor mouse(hardware(), no_errors);
  mouse.drive(600, 0.2, 0.2);
  EXPECT_LT(mouse.error(), 0.05) << "straight on";
  for (int i = 0; i < 5; ++i) {
    mouse.drive(200, 0.15, 0.27);
    mouse.drive(200, 0.27, 0.15);
  }
  EXPECT_GT(std::abs(mouse.body().motion().slip), 0.01) << "it slips";
  EXPECT_LT(mouse.error(), 1.0) << "after a metre of curves";
  EXPECT_NEAR(mouse.angle_error(), 0.0, 0.003);
}

TEST(Estimator, KnowsHowFastItIs) {
  OnAFloor mouse(hardware(), no_errors);
  for (int i = 0; i < 10; ++i) {
    mouse.drive(50, 0.05 * i, 0.04 * i);
    EXPECT_NEAR(mouse.estimator().speed(), mouse.body().motion().speed, 0.02 * mouse.body().motion().speed + 3.0);
    EXPECT_NEAR(mouse.estimator().turning(), mouse.body().motion().yaw, 0.002);
    EXPECT_NEAR(mouse.estimator().slip(), mouse.body().motion().slip, 0.003);
  }
}

TEST(Estimator, CountsOnWhereACounterWraps) {
  Hardware narrow = hardware();
  narrow.sensors.count_bits = 16.0;
  OnAFloor mouse(narrow, narrow, no_errors, 1), wide(hardware(), no_errors);
  for (OnAFloor* each : {&mouse, &wide}) each->drive(800, 0.3, 0.25);
  EXPECT_GT(std::abs(wide.body().sense().counts[0]), 1 << 16) << "it wraps";
  EXPECT_EQ(mouse.estimator().position(), wide.estimator().position());
}

/// Without a gyro the wheels measure its turns.
TEST(Estimator, KnowsWhereItIsWithoutAGyro) {
  Hardware blind = hardware();
  blind.sensors.gyro_step = 0.0;
  OnAFloor mouse(blind, blind, no_errors, 1);
  mouse.drive(300, 0.2, 0.2);
  for (int i = 0; i < 5; ++i) {
    mouse.drive(200, 0.15, 0.27);
    mouse.drive(200, 0.27, 0.15);
  }
  EXPECT_LT(mouse.error(), 1.5);
  EXPECT_NEAR(mouse.angle_error(), 0.0, 0.003);
  EXPECT_NEAR(mouse.estimator().turning(), mouse.body().motion().yaw, 0.3);
}

/// Wheels of different diameters seem to turn it: observations of its angle tell, and it keeps that where a hand
/// carries it elsewhere.
TEST(Estimator, LearnsTheMismatchOfItsWheelsWithoutAGyroAndKeepsIt) {
  Hardware blind = hardware();
  blind.sensors.gyro_step = 0.0;
  ErrorScale unequal = no_errors;
  unequal.variation = 1.0;
  unequal.causes.fill(0.0);
  unequal.causes[static_cast<std::size_t>(ErrorCause::encoders)] = 1.0;
  OnAFloor mouse(blind, blind, unequal, 3), unseen(blind, blind, unequal, 3);
  for (int i = 0; i < 30; ++i) {
    mouse.drive(50, 0.1, 0.1);
    unseen.drive(50, 0.1, 0.1);
    mouse.estimator().correct({-mouse.angle_error(), 0.0, 0.0, 1.0, 1e-6});
  }
  const double before = unseen.angle_error();
  for (OnAFloor* each : {&mouse, &unseen}) each->drive(1500, 0.1, 0.1);
  EXPECT_GT(std::abs(unseen.angle_error() - before), 0.03);
  EXPECT_LT(std::abs(mouse.angle_error()), 0.01);
  mouse.estimator().put(mouse.body().motion().position, mouse.body().motion().ahead);
  mouse.drive(1500, 0.1, 0.1);
  EXPECT_LT(std::abs(mouse.angle_error()), 0.015);
}

TEST(Estimator, KnowsHowFastItIsWithoutAnAccelerometer) {
  Hardware blind = hardware();
  blind.sensors.acceleration_step = 0.0;
  OnAFloor mouse(blind, blind, no_errors, 1);
  mouse.drive(200, 0.1, 0.1);
  for (int i = 0; i < 20; ++i) {
    mouse.drive(20, 0.1 + 0.01 * i, 0.1 + 0.01 * i);
    const double speed = mouse.body().motion().speed;
    EXPECT_NEAR(mouse.estimator().speed(), speed, 0.05 * speed + 3.0);
  }
  // It does not lag behind while it accelerates.
  mouse.drive(30, 0.5, 0.5);
  EXPECT_NEAR(mouse.estimator().speed(), mouse.body().motion().speed, 12.0);
  // In turns, the slip is that of the nominal tyres.
  mouse.drive(100, 0.1, 0.25);
  EXPECT_EQ(mouse.estimator().slip(), mouse.estimator().estimate().slip);
}

/// Of tyres that are not those of the nominal model: they give way more, or slide all through a curve.
TEST(Estimator, FeelsHowItSlips) {
  for (const bool slides : {false, true}) {
    Hardware built = hardware();
    (slides ? built.tyres.grip : built.tyres.stiffness) /= 6.0;
    OnAFloor mouse(built, no_errors);
    mouse.drive(400, 0.1, 0.1);
    bool slid = false;
    for (int curve = 0; curve < 3; ++curve) {
      for (int i = 0; i < 15; ++i) {
        mouse.drive(10, 0.0, 0.2);
        slid = slid || mouse.body().slid_within(1);
        const double slip = mouse.body().motion().slip;
        EXPECT_NEAR(mouse.estimator().slip(), slip, 0.02 + 0.1 * std::abs(slip));
      }
      EXPECT_GT(std::abs(mouse.body().motion().slip), 0.08) << "more than the book has it";
      mouse.drive(200, 0.1, 0.1);
      EXPECT_NEAR(mouse.estimator().slip(), 0.0, 0.01);
    }
    EXPECT_EQ(slid, slides);
    EXPECT_LT(mouse.error(), 25.0) << "after a metre and a half";
  }
}

/// What a mouse is told of its slip would make one that slides turn in.
TEST(Estimator, TellsOfTheSlipOfTheBook) {
  Hardware built = hardware();
  built.tyres.grip /= 6.0;
  OnAFloor mouse(built, no_errors);
  mouse.drive(400, 0.1, 0.1);
  mouse.drive(150, 0.0, 0.2);
  EXPECT_GT(std::abs(mouse.estimator().slip()), 0.08);
  EXPECT_LT(std::abs(mouse.estimator().estimate().slip), 0.06);
}

/// How sure a mouse is across its way behind a curve at 330 mm/s and 8 rad/s, whose accelerometer feels so much of what
/// a mouse feels that does not slip, and has that noise.
double across_a_curve(double felt, double noise) {
  Hardware book = hardware();
  book.noise = {};
  book.noise.acceleration = noise;
  book.variation = {.stiffness = 0.3};
  Estimator estimator(book, 90.0, 0.2);
  estimator.put({0.0, 0.0}, {1.0, 0.0});
  constexpr double speed = 330.0, turning = 8.0;
  Sense sense;
  for (int tick = 0; tick < 150; ++tick) {
    ++sense.tick;
    for (auto& counts : sense.counts) counts += static_cast<int>(speed * tick_seconds / book.sensors.count);
    sense.gyro = static_cast<std::int16_t>(turning / book.sensors.gyro_step);
    sense.acceleration[1] = static_cast<std::int16_t>(felt * speed * turning / book.sensors.acceleration_step);
    estimator.predict(sense);
  }
  const Direction way = estimator.way();
  return std::sqrt(estimator.variance_of(-way.sine, way.cosine, 0.0));
}

TEST(Estimator, IsLessSureAsideTheMoreItSlipsAndTheLessExactlyItFeelsThat) {
  EXPECT_LT(across_a_curve(1.0, 0.0), 0.6);
  EXPECT_GT(across_a_curve(0.8, 0.0), 1.0);
  EXPECT_GT(across_a_curve(0.6, 0.0), 1.5 * across_a_curve(0.8, 0.0));
  EXPECT_GT(across_a_curve(1.0, 350.0), 1.2 * across_a_curve(1.0, 0.0));
  EXPECT_GT(across_a_curve(1.0, 700.0), 1.4 * across_a_curve(1.0, 350.0));
}

TEST(Estimator, CountsATickOnce) {
  OnAFloor mouse(hardware(), no_errors);
  mouse.drive(300, 0.2, 0.25);
  const Position before = mouse.estimator().position();
  const Direction ahead = mouse.estimator().ahead();
  mouse.estimator().predict(mouse.body().sense());
  EXPECT_EQ(mouse.estimator().position(), before);
  EXPECT_EQ(mouse.estimator().ahead().sine, ahead.sine);
}

TEST(Estimator, IsLessSureTheFartherItHasDriven) {
  OnAFloor mouse(hardware(), {});
  double x = mouse.estimator().variance_of(1.0, 0.0, 0.0), angle = mouse.estimator().variance_of(0.0, 0.0, 1.0);
  for (int i = 0; i < 5; ++i) {
    mouse.drive(200, 0.15, 0.2);
    EXPECT_GT(mouse.estimator().variance_of(1.0, 0.0, 0.0), x);
    EXPECT_GT(mouse.estimator().variance_of(0.0, 0.0, 1.0), angle);
    x = mouse.estimator().variance_of(1.0, 0.0, 0.0);
    angle = mouse.estimator().variance_of(0.0, 0.0, 1.0);
  }
}

TEST(Estimator, BelievesAnObservationByHowSureBothAre) {
  Estimator estimator(hardware(), 90.0, 0.2);
  estimator.put({100.0, 100.0}, {1.0, 0.0});
  const double variance = estimator.variance_of(1.0, 0.0, 0.0);
  // As sure as the estimate: half of the way.
  EXPECT_TRUE(estimator.correct({2.0, 1.0, 0.0, 0.0, variance}));
  EXPECT_NEAR(estimator.position().x, 101.0, 1e-12);
  EXPECT_NEAR(estimator.position().y, 100.0, 1e-12);
  EXPECT_NEAR(estimator.variance_of(1.0, 0.0, 0.0), variance / 2.0, 1e-12);
}

TEST(Estimator, DoesNotBelieveWhatIsMoreThanThreeDeviationsOff) {
  Estimator estimator(hardware(), 90.0, 0.2);
  estimator.put({100.0, 100.0}, {1.0, 0.0});
  const double deviation = std::sqrt(2.0 * estimator.variance_of(1.0, 0.0, 0.0));
  const double variance = estimator.variance_of(1.0, 0.0, 0.0);
  EXPECT_FALSE(estimator.correct({3.1 * deviation, 1.0, 0.0, 0.0, variance}));
  EXPECT_EQ(estimator.position(), (Position{100.0, 100.0}));
  EXPECT_EQ(estimator.variance_of(1.0, 0.0, 0.0), variance);
  EXPECT_TRUE(estimator.correct({2.9 * deviation, 1.0, 0.0, 0.0, variance}));
}

/// A mouse that is lost: all that it sees is farther off than it believes possible, until it believes less.
TEST(Estimator, FindsItselfAgainAfterManyRejections) {
  Estimator estimator(hardware(), 90.0, 0.2);
  estimator.put({100.0, 100.0}, {1.0, 0.0});
  const double variance = estimator.variance_of(1.0, 0.0, 0.0);
  const double off = 8.0 * std::sqrt(2.0 * variance);
  int rejected = 0;
  while (!estimator.correct({off, 1.0, 0.0, 0.0, variance}) && rejected < 1000) ++rejected;
  EXPECT_GE(rejected, 20);
  EXPECT_LE(rejected, 60);
  EXPECT_GT(estimator.position().x, 100.0 + 0.5 * off);
}

/// A few that are wrong among others that fit do not count as lost.
TEST(Estimator, StaysSureWhereMostObservationsFit) {
  Estimator estimator(hardware(), 90.0, 0.2);
  estimator.put({100.0, 100.0}, {1.0, 0.0});
  const double variance = estimator.variance_of(1.0, 0.0, 0.0);
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(estimator.correct({20.0 * std::sqrt(variance), 1.0, 0.0, 0.0, 0.01 * variance}));
    if (i % 10 == 9) {
      EXPECT_TRUE(estimator.correct({0.0, 0.0, 1.0, 0.0, variance}));
    }
  }
  EXPECT_EQ(estimator.variance_of(1.0, 0.0, 0.0), variance);
}

/// On a straight it learns the offset of its accelerometer, so that a curve behind it has the true slip.
TEST(Estimator, MeasuresTheOffsetOfItsAccelerometer) {
  Hardware built = hardware();
  built.noise = {};
  built.noise.shaking_speed = 1.0;
  built.variation = {.acceleration_bias = 900.0};
  std::uint64_t seed = 1;
  while (std::abs(RobotSample(built, {}, {7, 7}, seed).acceleration[1]) < 700.0) ++seed;
  OnAFloor mouse(built, built, {}, seed);
  mouse.drive(700, 0.1, 0.1);
  for (int i = 0; i < 15; ++i) {
    mouse.drive(10, 0.0, 0.2);
    EXPECT_NEAR(mouse.estimator().slip(), mouse.body().motion().slip, 0.02);
  }
}

/// By every fourth reading it is about as sure as by all of them.
TEST(Estimator, IsLessSureByTheTimeThatPassesHoweverOftenItReads) {
  const auto angle_variance = [](int step) {
    Estimator estimator(hardware(), 90.0, 0.2);
    estimator.put({0.0, 0.0}, {1.0, 0.0});
    Sense sense;
    for (int tick = 0; tick <= 2000; tick += step) {
      sense.tick = static_cast<std::uint32_t>(tick + 1);
      estimator.predict(sense);
    }
    return estimator.variance_of(0.0, 0.0, 1.0) - square(2.0 * hardware().variation.placement_turn);
  };
  EXPECT_NEAR(angle_variance(4) / angle_variance(1), 1.0, 0.35);
}

TEST(Estimator, TurnsAnErrorOfTheAngleIntoOneAside) {
  OnAFloor mouse(hardware(), no_errors);
  const double turned = mouse.estimator().variance_of(0.0, 0.0, 1.0);
  const Direction ahead = direction_of(0.4);
  const double before = mouse.estimator().variance_of(-ahead.sine, ahead.cosine, 0.0);
  mouse.drive(1000, 0.2, 0.2);
  const Position way = mouse.body().motion().position - Position{3500.0, 3500.0};
  const double length = std::hypot(way.x, way.y);
  ASSERT_GT(length, 200.0);
  // What it is aside, a hundredth of a degree of noise apart, is the angle at which it was put down times the way.
  EXPECT_GT(mouse.estimator().variance_of(-ahead.sine, ahead.cosine, 0.0), before + square(length) * turned);
  EXPECT_LT(mouse.estimator().variance_of(-ahead.sine, ahead.cosine, 0.0), before + 2.0 * square(length) * turned);
}

TEST(Estimator, LearnsHowMuchItsEncodersOverstate) {
  Hardware built = hardware();
  built.noise = {};
  built.noise.shaking_speed = 1.0;
  built.variation = {};
  OnAFloor mouse(built, {});
  // A way of which it is told each so often where it is: it is told of less than it counts.
  for (int i = 0; i < 30; ++i) {
    mouse.drive(100, 0.2, 0.2);
    const Position truth = mouse.body().motion().position, believed = mouse.estimator().position();
    const Direction& ahead = mouse.estimator().ahead();
    // Its wheels are a hundredth smaller than it thinks.
    const double driven = (truth.x - 3500.0) * ahead.cosine + (truth.y - 3500.0) * ahead.sine;
    const double told = (believed.x - 3500.0) * ahead.cosine + (believed.y - 3500.0) * ahead.sine;
    mouse.estimator().correct({0.99 * driven - told, ahead.cosine, ahead.sine, 0.0, 0.1});
  }
  // By now it foresees what it will be told.
  const Position before = mouse.estimator().position(), truth = mouse.body().motion().position;
  mouse.drive(200, 0.2, 0.2);
  const Position believed = mouse.estimator().position() - before, driven = mouse.body().motion().position - truth;
  EXPECT_NEAR(std::hypot(believed.x, believed.y) / std::hypot(driven.x, driven.y), 0.99, 0.002);
}

/// Over how many deviations an estimate is off: the square of its error by its covariance, of three numbers 3 on
/// average.
class Consistency {
 public:
  void add(test::Driven& driven) {
    const PoseEstimate& estimator = driven.controller().estimate();
    const auto of = [&](double x, double y, double angle) { return estimator.variance_of(x, y, angle); };
    // The entries of the covariance, by the variances of sums.
    const double xx = of(1, 0, 0), yy = of(0, 1, 0), aa = of(0, 0, 1), xy = (of(1, 1, 0) - xx - yy) / 2.0,
                 xa = (of(1, 0, 1) - xx - aa) / 2.0, ya = (of(0, 1, 1) - yy - aa) / 2.0;
    const Position error = driven.error();
    const double ex = error.x, ey = error.y, ea = driven.angle_error();
    // By Cramer's rule.
    const double determinant = xx * (yy * aa - ya * ya) - xy * (xy * aa - ya * xa) + xa * (xy * ya - yy * xa);
    ASSERT_GT(determinant, 0.0);
    const double sx = (yy * aa - ya * ya) * ex + (xa * ya - xy * aa) * ey + (xy * ya - xa * yy) * ea;
    const double sy = (ya * xa - xy * aa) * ex + (xx * aa - xa * xa) * ey + (xa * xy - xx * ya) * ea;
    const double sa = (xy * ya - yy * xa) * ex + (xy * xa - xx * ya) * ey + (xx * yy - xy * xy) * ea;
    squares_.push_back((ex * sx + ey * sy + ea * sa) / determinant);
  }
  double mean() const {
    double sum = 0.0;
    for (const double one : squares_) sum += one;
    return sum / static_cast<double>(squares_.size());
  }
  double share_above(double bound) const {
    return static_cast<double>(
               std::count_if(squares_.begin(), squares_.end(), [&](double one) { return one > bound; })) /
           static_cast<double>(squares_.size());
  }
  std::size_t size() const { return squares_.size(); }

 private:
  std::vector<double> squares_;
};

/// Random search moves in a maze, never against a wall.
void wander(test::Driven& driven, int moves, std::uint64_t seed, Consistency& consistency) {
  Rng rng(seed);
  if (!driven.drive_on()) return;
  for (int i = 0; i < moves; ++i) {
    const SearchPlace place = driven.controller().place();
    std::vector<Action> ways;
    for (const int rotation : {0, -90, 90}) {
      const Action step = Action::step(rotation, 1);
      if (driven.maze().is_open(place.pose.cell, after_search(place, step).pose.heading)) ways.push_back(step);
    }
    const Action step =
        ways.empty() ? Action::step(180, 1) : ways[static_cast<std::size_t>(rng.below(static_cast<int>(ways.size())))];
    if (!driven.search(step)) return;
    consistency.add(driven);
  }
}

TEST(Estimator, IsAsSureAsItIsRight) {
  LABMOUSE_SKIP_SANITIZED();
  for (const DriveModel* model : {&test::kerise(), &test::classic(), &test::beginner()}) {
    SCOPED_TRACE(model->robot.name);
    Consistency consistency;
    for (int i = 0; i < test::some_of(120); ++i) {
      const auto seed = static_cast<std::uint64_t>(i);
      const Maze maze = contest_generator.make({{16, 16}, seed, 60});
      test::Driven driven(maze, *model, {}, seed);
      wander(driven, 40, seed, consistency);
    }
    ASSERT_GT(consistency.size(), 200U);
    // Of three numbers; rather too careful than too sure.
    EXPECT_GT(consistency.mean() / 3.0, 0.35);
    EXPECT_LT(consistency.mean() / 3.0, 1.2);
    // The bounds of a chi-squared number of three for a twentieth and a hundredth; steps of the floor are rare and
    // large, so there are more of these.
    EXPECT_LT(consistency.share_above(7.81), 0.1);
    EXPECT_LT(consistency.share_above(11.34), 0.05);
  }
}

}  // namespace
}  // namespace labmouse
