// A record of the physical world as the page plays it: both mice, what the true one reads, and what it touches.
#include <gmock/gmock.h>

#include <cmath>

#include "labmouse/hardware/beam.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::json;
using ::testing::SizeIs;

DriveRecordFile recorded(double noise, int trace_every, std::uint64_t seed = 1) {
  PhysicalConditions conditions = test::at_errors(noise);
  conditions.trace_every = trace_every;
  return test::physical_file("flood-return", conditions, seed);
}

json played(const DriveRecordFile& file) {
  return test::answer("open", {{"name", "a.jsonl"}}, write_drive_record(file))["play"];
}

TEST(PageBodies, AreBothMicePointByPoint) {
  const DriveRecordFile file = recorded(0.5, 20);
  const json play = played(file);
  EXPECT_EQ(play["world"], "physical");
  const json &path = play["drive"]["path"], &bodies = play["drive"]["bodies"], &belief = bodies["belief"];
  const std::size_t points = path["t"].size();
  ASSERT_GT(points, 100U);
  for (const char* number : {"x", "y", "heading"}) ASSERT_THAT(belief[number], SizeIs(points));
  ASSERT_THAT(bodies["distances"], SizeIs(4 * points));
  double most = 0.0;
  for (std::size_t i = 0; i < points; ++i) {
    const auto off = [&](const char* number) {
      return std::abs(belief[number][i].get<double>() - path[number][i].get<double>());
    };
    most = std::max({most, off("x"), off("y")});
    EXPECT_LT(off("x") + off("y"), 0.6);
    EXPECT_LT(off("heading"), 1.0);
  }
  EXPECT_GT(most, 0.002) << "the mouse does not know where it is";
  EXPECT_THAT(bodies["looks"], SizeIs(file.physical->notes.looks.size()));
  EXPECT_THAT(bodies["touches"], SizeIs(file.physical->notes.touches.size()));
}

TEST(PageBodies, HaveBeamsThatEndAtTheWall) {
  const json bodies = played(recorded(0.0, 20))["drive"]["bodies"];
  const auto model = test::drive_model("kerise");
  const Hardware& hardware = *model->robot.hardware;
  const Beam& right = hardware.sensors.infrared[0].beam;
  EXPECT_NEAR(bodies["beams"][0]["left"].get<double>(), right.aside / 90.0, 1e-4);
  EXPECT_GT(bodies["beams"][0]["angle"].get<double>(), 1.0) << "clockwise";
  // In the start, between two walls.
  const double distance = bodies["distances"][0];
  EXPECT_NEAR(distance * std::sin(std::abs(right.angle)), 0.5 - 1.0 / 30.0 - std::abs(right.aside) / 90.0, 0.02);
}

TEST(PageBodies, HaveTheirTouchesWhereTheyWere) {
  LABMOUSE_SKIP_SANITIZED();
  int touches = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const DriveRecordFile file = recorded(8.0, 20, seed);
    const json play = played(file);
    const json& bodies = play["drive"]["bodies"];
    for (std::size_t i = 0; i < bodies["touches"].size(); ++i, ++touches) {
      const WallTouch& touch = file.physical->notes.touches[i];
      EXPECT_EQ(bodies["touches"][i]["crash"], touch.crash);
      EXPECT_NEAR(bodies["touches"][i]["x"].get<double>() * 90.0, touch.at.position.x, 0.01);
    }
  }
  EXPECT_GT(touches, 0);
}

TEST(PageBodies, AreNotThereWithoutATrace) { EXPECT_FALSE(played(recorded(1.0, 0))["drive"].contains("bodies")); }

}  // namespace
}  // namespace labmouse
