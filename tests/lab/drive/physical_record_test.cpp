#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/pictures/drive_picture.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::at_errors;
using test::physical_file;
using test::Says;
using ::testing::HasSubstr;

PhysicalConditions traced(double noise) {
  PhysicalConditions conditions = at_errors(noise);
  conditions.trace_every = 50;
  return conditions;
}

DriveRecordFile read(const std::string& text) {
  ReadDriveRecordResult result = read_drive_record(text);
  EXPECT_TRUE(result.file) << (result.problems.empty() ? "" : result.problems.front().reason);
  return result.file ? std::move(*result.file) : physical_file("flood", at_errors(0.0));
}

std::string changed(std::string text, const std::string& old, const std::string& now) {
  const auto place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return place == std::string::npos ? text : text.replace(place, old.size(), now);
}

TEST(PhysicalRecord, IsReadAsItWasWritten) {
  for (const double noise : {0.0, 1.0, 5.0})
    for (const std::uint64_t seed : {1, 2}) {
      const DriveRecordFile written = physical_file("certify", traced(noise), seed);
      const DriveRecordFile file = read(write_drive_record(written));
      ASSERT_TRUE(file.physical);
      EXPECT_EQ(file.record, written.record);
      EXPECT_EQ(write_drive_record(file), write_drive_record(written));
      EXPECT_EQ(file.physical->notes.ends, written.physical->notes.ends);
      EXPECT_EQ(file.physical->notes.looks, written.physical->notes.looks);
      EXPECT_EQ(file.physical->notes.actions, written.physical->notes.actions);
      EXPECT_EQ(file.physical->notes.touches.size(), written.physical->notes.touches.size());
      EXPECT_EQ(file.physical->notes.trace.size(), written.physical->notes.trace.size());
      EXPECT_EQ(file.model->robot.hardware, written.model->robot.hardware);
      EXPECT_EQ(replay(file), "") << noise << ' ' << seed;
    }
}

TEST(PhysicalRecord, OfAMapThatWeighsDrivesAgain) {
  LABMOUSE_SKIP_SANITIZED();
  int turned = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    PhysicalConditions conditions = traced(1.2);
    conditions.map = MapKind::log_odds;
    const DriveRecordFile file = read(write_drive_record(physical_file("certify", conditions, seed)));
    EXPECT_EQ(file.physical->conditions.map, MapKind::log_odds);
    EXPECT_EQ(replay(file), "") << seed;
    turned += file.physical->notes.contradictions;
  }
  EXPECT_GT(turned, 0);
}

TEST(PhysicalRecord, WithoutAKindOfMapIsOfOneThatNeverForgets) {
  const std::string text = write_drive_record(physical_file("certify", traced(2.0)));
  EXPECT_EQ(read(changed(text, ",\"map\":\"first\"", "")).physical->conditions.map, MapKind::first);
  EXPECT_FALSE(read_drive_record(changed(text, "\"map\":\"first\"", "\"map\":\"last\"")).file);
}

TEST(PhysicalRecord, IsReadUnderAllConditionsThatCanBeChosen) {
  const auto is_read = [](double noise, double variation, double pace, double search_speed) {
    DriveRecordFile file = physical_file("flood", at_errors(0.0));
    PhysicalConditions& conditions = file.physical->conditions;
    conditions.errors.noise = noise;
    conditions.errors.variation = variation;
    conditions.controller.pace = pace;
    conditions.controller.search_speed = search_speed;
    return read_drive_record(write_drive_record(file)).file.has_value();
  };
  EXPECT_TRUE(is_read(most_noise, most_variation, least_pace, most_search_speed));
  // Earlier versions took it for a speed.
  EXPECT_TRUE(is_read(1.0, 1.0, 1.0, least_search_speed / 2.0));
  EXPECT_FALSE(is_read(1.01 * most_noise, 1.0, 1.0, 0.0));
  EXPECT_FALSE(is_read(1.0, 1.01 * most_variation, 1.0, 0.0));
  EXPECT_FALSE(is_read(1.0, 1.0, 0.99 * least_pace, 0.0));
  EXPECT_FALSE(is_read(1.0, 1.0, 1.0, 1.01 * most_search_speed));
}

/// They called the causes of errors groups, had fewer of them, and named one otherwise.
TEST(PhysicalRecord, OfEarlierVersionsAreRead) {
  PhysicalConditions conditions = at_errors(0.0);
  constexpr auto tof = static_cast<std::size_t>(ErrorCause::ranger), gyro = static_cast<std::size_t>(ErrorCause::gyro);
  conditions.errors.causes[tof] = 0.5;
  conditions.errors.causes[gyro] = 0.25;
  const std::string text = write_drive_record(physical_file("flood", conditions));
  const std::string earlier = changed(
      changed(changed(text, "\"causes\":", "\"groups\":"), "\"ToF sensor\":", "\"ranger\":"), "\"posts\":1.0,", "");
  const ErrorScale errors = read(earlier).physical->conditions.errors;
  EXPECT_EQ(errors.causes, conditions.errors.causes);
}

TEST(PhysicalRecord, DisagreesWhereAnythingWasChanged) {
  const std::string text = write_drive_record(physical_file("flood-return", traced(2.0), 5));
  EXPECT_EQ(replay(read(text)), "");
  EXPECT_THAT(replay(read(changed(text, "\"seed\":5", "\"seed\":6"))), HasSubstr("driven again"));
  EXPECT_THAT(replay(read(changed(text, "\"noise\":2.0", "\"noise\":2.25"))), HasSubstr("driven again"));
  EXPECT_THAT(replay(read(changed(text, "\"trace\":[", "\"trace\":[1"))), HasSubstr("driven again"));
  EXPECT_NE(replay(read(changed(text, "\"score\":{\"value\":", "\"score\":{\"value\":1"))), "");
}

/// A header alone may not ask for more than a machine has: the trace of a long contest, or a contest of years.
TEST(PhysicalRecord, IsRefusedWhereItsContestWouldBeTooLong) {
  const std::string text = write_drive_record(physical_file("flood", at_errors(0.0)));
  const auto problem = [&](const std::string& limit, const std::string& every) {
    const ReadDriveRecordResult result =
        read_drive_record(changed(changed(text, "\"time_limit\":300000000", "\"time_limit\":" + limit),
                                  "\"trace_every\":0", "\"trace_every\":" + every));
    return result.file ? "" : result.problems.front().reason;
  };
  EXPECT_EQ(problem("300000000", "1"), "");
  EXPECT_EQ(problem("7200000000", "15"), "");
  // It says how often the contest may be traced.
  EXPECT_THAT(problem("7200000000", "1"), Says("trace", "500000", "15 ms"));
  EXPECT_THAT(problem("7200000001", "0"), Says("time_limit", "1000000 to 7200000000"));
}

TEST(PhysicalRecord, OfAnotherEditionIsShownAndNotDriven) {
  DriveRecordFile file = physical_file("flood", traced(1.0));
  file.physical->edition = physical_edition + 1;
  const DriveRecordFile later = read(write_drive_record(file));
  EXPECT_THAT(replay(later), Says(std::to_string(physical_edition + 1), std::to_string(physical_edition), "edition"));
}

TEST(PhysicalRecord, OfWhichTheEndIsMissingAgreesAsFarAsItGoes) {
  const std::string text = write_drive_record(physical_file("flood", traced(1.0)));
  std::size_t line = 0, lines = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos && end + 1 < text.size();
       end = text.find('\n', end + 1)) {
    if (++line % static_cast<std::size_t>(test::slowness) != 0) continue;
    const ReadDriveRecordResult part = read_drive_record(std::string_view(text).substr(0, end + 1));
    if (!part.file) continue;
    ++lines;
    EXPECT_FALSE(part.file->ended);
    EXPECT_EQ(replay(*part.file), "");
  }
  EXPECT_GT(lines, 0U);
}

}  // namespace
}  // namespace labmouse
