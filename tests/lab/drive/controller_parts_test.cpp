// Contests in which a part of the controller is somebody else's.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "labmouse/contest/code_contest.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/controller/controller.hpp"
#include "labmouse/controller/parts.hpp"
#include "labmouse/external/external_parts.hpp"
#include "labmouse/lab/mice/controller_lines.hpp"
#include "labmouse/lab/mice/parts_in_c.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::Says;

const DriveModel& model() {
  static const auto model = test::drive_model("kerise");
  return *model;
}
constexpr double cell = 90.0;
const Hardware& hardware() { return *model().robot.hardware; }

/// A contest of flood-return in the ring.
PhysicalRecord contest(const ControllerParts& parts, double noise = 1.0, std::uint64_t seed = 1,
                       MazeTime limit = 300'000'000) {
  PhysicalConditions conditions = test::at_errors(noise);
  conditions.trace_every = 20;
  DriveRules rules = find_rules("all-japan").rules;
  rules.time_limit = limit;
  Briefing briefing = brief(test::ring(), rules, model(), seed);
  briefing.sight = 1;
  const BuiltinMouse& entry = *find_mouse("flood-return");
  const auto strategy = entry.drive(briefing, Settings(entry.parameters));
  return drive_physically(test::ring(), rules, model(), conditions, seed, *strategy, parts);
}

ControllerBriefing briefing() {
  static const DriveRules rules = find_rules("all-japan").rules;
  return controller_briefing(test::ring(), rules, model(), {}, 1);
}

/// Our parts, made as the controller makes them.
struct Ours {
  Gains gains = gains_for(hardware(), cell);
  CorrectedEstimator estimator{hardware(), cell, test::ring().size(), {}, gains.speed_filter};
  WallReader reader{hardware(), cell};
  MotorTracker tracker{gains, hardware().motors};
};

/// All but who made the parts.
void expect_same(PhysicalRecord record, const PhysicalRecord& other) {
  EXPECT_TRUE(record.foreign_parts);
  record.foreign_parts = other.foreign_parts;
  EXPECT_EQ(record, other);
}

TEST(ControllerParts, OfOursInPlaceOfOursChangeNothing) {
  LABMOUSE_SKIP_SANITIZED();
  for (const double noise : {0.0, 1.0, 4.0})
    for (const std::uint64_t seed : {1U, 2U}) {
      const PhysicalRecord plain = contest({}, noise, seed);
      EXPECT_FALSE(plain.foreign_parts);
      EXPECT_FALSE(plain.trace.empty());
      Ours first, second, third, all;
      expect_same(contest({&first.estimator, nullptr, nullptr}, noise, seed), plain);
      expect_same(contest({nullptr, &second.reader, nullptr}, noise, seed), plain);
      expect_same(contest({nullptr, nullptr, &third.tracker}, noise, seed), plain);
      expect_same(contest({&all.estimator, &all.reader, &all.tracker}, noise, seed), plain);
    }
}

int crashes(const PhysicalRecord& record) {
  return static_cast<int>(std::count_if(record.ends.begin(), record.ends.end(), is_crash));
}

/// Believes to be a third of a cell east of where it is.
class Shifted final : public EstimatorPart {
 public:
  void put(const Position& position, const Direction& ahead) override { ours_.estimator.put(position, ahead); }
  PoseEstimate estimate(const Sense& sense, const Target& target, const Knowledge* known) override {
    PoseEstimate estimate = ours_.estimator.estimate(sense, target, known);
    estimate.position.x += cell / 3.0;
    return estimate;
  }

 private:
  Ours ours_;
};

TEST(ControllerParts, RuinAContestWhereAnEstimatorIsElsewhere) {
  Shifted shifted;
  const PhysicalRecord record = contest({&shifted, nullptr, nullptr}, 0.0);
  EXPECT_GT(crashes(record), 0);
  EXPECT_EQ(crashes(contest({}, 0.0)), 0);
}

/// Takes walls for none, and none for walls.
class Contrary final : public ReaderPart {
 public:
  void begin(const Pose& pose) override { ours_.reader.begin(pose); }
  void read(const Sense& sense, const PoseEstimate& estimate) override { ours_.reader.read(sense, estimate); }
  WallEvidence evidence(const PoseEstimate& estimate) const override {
    const WallEvidence right = ours_.reader.evidence(estimate);
    return {static_cast<Evidence>(-right.left), static_cast<Evidence>(-right.ahead),
            static_cast<Evidence>(-right.right)};
  }

 private:
  Ours ours_;
};

TEST(ControllerParts, RuinAContestWhereAReaderIsContrary) {
  Contrary contrary;
  const PhysicalRecord record = contest({nullptr, &contrary, nullptr}, 0.0);
  EXPECT_GT(record.wrong_walls, 0);
  EXPECT_NE(record.drive.outcome, DriveOutcome::finished);
}

/// Has its motors crossed.
class Crossed final : public TrackerPart {
 public:
  void reset() override { ours_.tracker.reset(); }
  Drive follow(const Sense& sense, const Target& target, const PoseEstimate& estimate) override {
    const Drive right = ours_.tracker.follow(sense, target, estimate);
    return {right.right, right.left};
  }

 private:
  Ours ours_;
};

TEST(ControllerParts, RuinAContestWhereATrackerHasItsMotorsCrossed) {
  Crossed crossed;
  EXPECT_GT(crashes(contest({nullptr, nullptr, &crossed}, 0.0)), 0);
}

/// Says numbers that are none, at last.
class Senseless final : public EstimatorPart, public TrackerPart {
 public:
  explicit Senseless(double number) : number_(number) {}

  void put(const Position& position, const Direction& ahead) override { estimate_ = {position, ahead, 0, 0, 0, {}}; }
  PoseEstimate estimate(const Sense&, const Target&, const Knowledge*) override {
    PoseEstimate said = estimate_;
    switch (++ticks_ % 6) {
      case 0:
        said.position.x = number_;
        break;
      case 1:
        said.ahead = {number_, number_};
        break;
      case 2:
        said.covariance[1][1] = number_;
        break;
      case 3:
        said.speed = number_;
        break;
      case 4:
        said.turning = number_;
        break;
      default:
        said.slip = number_;
    }
    return said;
  }
  void reset() override {}
  Drive follow(const Sense&, const Target&, const PoseEstimate& estimate) override {
    EXPECT_EQ(estimate.position, estimate_.position);
    EXPECT_EQ(estimate.covariance[1][1], 0.0);
    const auto number = static_cast<float>(number_);
    return {number, -number};
  }

 private:
  double number_;
  PoseEstimate estimate_;
  int ticks_ = 0;
};

TEST(ControllerParts, AreNotBelievedWhereTheyMakeNoSense) {
  for (const double number :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e30}) {
    Senseless estimator(number), tracker(number);
    PhysicalRecord record = contest({&estimator, nullptr, nullptr});
    for (const TracePoint& point : record.trace) EXPECT_TRUE(std::abs(point.estimate->position.x) < 1000.0);
    record = contest({&tracker, nullptr, &tracker});
    for (const TracePoint& point : record.trace) EXPECT_TRUE(std::abs(point.truth.position.x) < 1000.0);
  }
}

TEST(ControllerParts, HaveRecordsThatAreShownAndNotDrivenAgain) {
  Ours ours;
  const PhysicalConditions conditions = test::at_errors(1.0);
  DriveRecordFile file = test::physical_file("flood-return", conditions);
  EXPECT_EQ(replay(file), "");
  file.physical->notes.foreign_parts = true;
  const auto read = read_drive_record(write_drive_record(file));
  ASSERT_TRUE(read.file);
  EXPECT_TRUE(read.file->physical->notes.foreign_parts);
  EXPECT_THAT(replay(*read.file), Says("not", "driven", "again"));
}

/// Ours, behind a table of functions in C: no table knows what is known of walls.
struct InC {
  Ours ours;
};
InC& at(void* memory) { return *static_cast<InC*>(memory); }

Sense sense_of(const labmouse_sense& read) {
  Sense sense;
  sense.tick = read.tick;
  std::copy_n(read.counts, 2, sense.counts.begin());
  sense.gyro = read.gyro;
  std::copy_n(read.acceleration, 2, sense.acceleration.begin());
  std::copy_n(read.infrared, 4, sense.infrared.begin());
  sense.ranges[0] = {read.ranges[0], read.ranges_new[0] != 0};
  sense.millivolts = read.millivolts;
  return sense;
}
Direction direction_from(const labmouse_direction& it) { return {it.sine, it.cosine}; }
Target target_of(const labmouse_target& it) {
  return {{it.x, it.y}, direction_from(it.ahead), it.speed, it.speeding, it.turning, it.twisting};
}
PoseEstimate estimate_from(const labmouse_estimate& it) {
  PoseEstimate estimate = {{it.x, it.y}, direction_from(it.ahead), it.slip, it.speed, it.turning, {}};
  for (std::size_t row = 0; row < 3; ++row) std::copy_n(it.covariance[row], 3, estimate.covariance[row].begin());
  return estimate;
}

void* begin_in_c(const labmouse_briefing*) { return new InC; }
void end_in_c(void* memory) { delete static_cast<InC*>(memory); }
void put_in_c(void* memory, double x, double y, labmouse_direction ahead) {
  at(memory).ours.estimator.put({x, y}, direction_from(ahead));
}
labmouse_estimate estimate_in_c(void* memory, const labmouse_sense* sense, const labmouse_target* target) {
  const PoseEstimate is = at(memory).ours.estimator.estimate(sense_of(*sense), target_of(*target), nullptr);
  labmouse_estimate said{};
  said.x = is.position.x;
  said.y = is.position.y;
  said.ahead = {is.ahead.cosine, is.ahead.sine};
  said.slip = is.slip;
  said.speed = is.speed;
  said.turning = is.turning;
  for (std::size_t row = 0; row < 3; ++row) std::copy_n(is.covariance[row].begin(), 3, said.covariance[row]);
  return said;
}
void look_in_c(void* memory, labmouse_cell place, labmouse_heading heading) {
  at(memory).ours.reader.begin({{place.x, place.y}, static_cast<Heading>(heading)});
}
void read_in_c(void* memory, const labmouse_sense* sense, const labmouse_estimate* estimate) {
  at(memory).ours.reader.read(sense_of(*sense), estimate_from(*estimate));
}
labmouse_evidence evidence_in_c(void* memory, const labmouse_estimate* estimate) {
  const WallEvidence evidence = at(memory).ours.reader.evidence(estimate_from(*estimate));
  return {evidence.left, evidence.ahead, evidence.right};
}
void rest_in_c(void* memory) { at(memory).ours.tracker.reset(); }
std::int32_t whole_duty(float duty) { return static_cast<std::int32_t>(std::lround(duty * ControllerTick::full)); }
labmouse_duties follow_in_c(void* memory, const labmouse_sense* sense, const labmouse_target* target,
                            const labmouse_estimate* estimate) {
  const Drive duties = at(memory).ours.tracker.follow(sense_of(*sense), target_of(*target), estimate_from(*estimate));
  return {whole_duty(duties.left), whole_duty(duties.right)};
}

/// In C++ what the table can say: without what is known of walls, and in whole duties.
class Blinkered final : public EstimatorPart, public TrackerPart {
 public:
  void put(const Position& position, const Direction& ahead) override { ours_.estimator.put(position, ahead); }
  PoseEstimate estimate(const Sense& sense, const Target& target, const Knowledge*) override {
    return ours_.estimator.estimate(sense, target, nullptr);
  }
  void reset() override { ours_.tracker.reset(); }
  Drive follow(const Sense& sense, const Target& target, const PoseEstimate& estimate) override {
    const Drive duties = ours_.tracker.follow(sense, target, estimate);
    return ControllerTick{static_cast<std::int16_t>(whole_duty(duties.left)),
                          static_cast<std::int16_t>(whole_duty(duties.right))}
        .drive();
  }

 private:
  Ours ours_;
};

TEST(PartsInC, DriveAsTheyDoWithoutATable) {
  LABMOUSE_SKIP_SANITIZED();
  constexpr struct labmouse_parts estimator = {begin_in_c, put_in_c, estimate_in_c, nullptr, nullptr,
                                               nullptr,    nullptr,  nullptr,       end_in_c};
  constexpr struct labmouse_parts reader = {begin_in_c,    nullptr, nullptr, look_in_c, read_in_c,
                                            evidence_in_c, nullptr, nullptr, end_in_c};
  constexpr struct labmouse_parts tracker = {begin_in_c, nullptr,   nullptr,     nullptr, nullptr,
                                             nullptr,    rest_in_c, follow_in_c, end_in_c};
  const auto by_table = [](const struct labmouse_parts& table, std::uint64_t seed) {
    const auto parts = parts_in_c(table, briefing());
    return contest(parts->parts(), 2.0, seed);
  };
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Blinkered first, second;
    expect_same(by_table(estimator, seed), contest({&first, nullptr, nullptr}, 2.0, seed));
    expect_same(by_table(reader, seed), contest({}, 2.0, seed));
    expect_same(by_table(tracker, seed), contest({nullptr, nullptr, &second}, 2.0, seed));
  }
}

#ifdef LABMOUSE_PART_PROGRAM

Launch part_program(const std::vector<std::string>& words) {
  Launch launch;
  launch.words = {LABMOUSE_PART_PROGRAM};
  launch.words.insert(launch.words.end(), words.begin(), words.end());
  launch.limits.silence = launch.limits.contest = std::chrono::minutes(10);
  launch.limits.processor_seconds = 600;
  return launch;
}

TEST(ExternalParts, DriveAsTheyDoWithoutAProgram) {
  LABMOUSE_SKIP_SANITIZED();
  constexpr MazeTime limit = 12'000'000;
  const auto by_program = [](const std::vector<std::string>& words, std::uint64_t seed) {
    ExternalParts program(part_program(words), controller_lines(briefing()));
    const PhysicalRecord record = contest(program.parts(), 2.0, seed, limit);
    EXPECT_EQ(program.last_words(), "");
    return record;
  };
  Blinkered first, second, third, fourth;
  expect_same(by_program({"estimator"}, 1), contest({&first, nullptr, nullptr}, 2.0, 1, limit));
  expect_same(by_program({"reader"}, 2), contest({}, 2.0, 2, limit));
  expect_same(by_program({"tracker"}, 3), contest({nullptr, nullptr, &second}, 2.0, 3, limit));
  expect_same(by_program({"tracker", "estimator", "reader"}, 4), contest({&third, nullptr, &fourth}, 2.0, 4, limit));
}

TEST(ExternalParts, ThatEndAfterAScoreLeaveIt) {
  LABMOUSE_SKIP_SANITIZED();
  const auto ended_after = [](const std::string& ticks) {
    ExternalParts program(part_program({"until", ticks, "reader"}), controller_lines(briefing()));
    return contest(program.parts(), 0.0);
  };
  const PhysicalRecord whole = contest({}, 0.0), early = ended_after("1000"), late = ended_after("6000");
  for (const PhysicalRecord* record : {&early, &late}) {
    EXPECT_EQ(record->drive.reason, ForfeitReason::ended_early);
    ASSERT_FALSE(record->ends.empty());
    EXPECT_EQ(record->ends.back(), RunEnd::given_up);
    EXPECT_LT(record->trace.size(), whole.trace.size());
  }
  EXPECT_EQ(early.drive.outcome, DriveOutcome::forfeit);
  EXPECT_EQ(late.drive.outcome, DriveOutcome::finished);
  // Nothing is driven from then on.
  EXPECT_EQ(early.drive.runs.back().end, 1'000'000);
}

#endif

TEST(PartsInC, AreOursWhereTheTableHasNone) {
  constexpr struct labmouse_parts none = {};
  const auto parts = parts_in_c(none, briefing());
  EXPECT_FALSE(parts->parts().any());
}

TEST(PartsInC, StayWithinWhatTheyMaySay) {
  constexpr struct labmouse_parts loud = {
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      [](void*, const labmouse_estimate*) -> labmouse_evidence {
        return {1000, -1000, 5};
      },
      nullptr,
      [](void*, const labmouse_sense*, const labmouse_target*, const labmouse_estimate*) -> labmouse_duties {
        return {1 << 30, -(1 << 30)};
      },
      nullptr};
  const auto parts = parts_in_c(loud, briefing());
  EXPECT_EQ(parts->parts().reader->evidence({}), (WallEvidence{127, -127, 5}));
  EXPECT_EQ(parts->parts().tracker->follow({}, {}, {}), (Drive{1.0F, -1.0F}));
}

}  // namespace
}  // namespace labmouse
