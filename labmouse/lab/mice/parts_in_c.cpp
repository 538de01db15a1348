#include "labmouse/lab/mice/parts_in_c.hpp"

#include <algorithm>

#include "labmouse/lab/mice/in_c.hpp"

namespace labmouse {
namespace {

labmouse_direction direction_in_c(const Direction& direction) { return {direction.cosine, direction.sine}; }

labmouse_target target_in_c(const Target& target) {
  return {target.position.x, target.position.y, direction_in_c(target.ahead), target.speed, target.speeding,
          target.turning,    target.twisting};
}

labmouse_estimate estimate_in_c(const PoseEstimate& estimate) {
  labmouse_estimate told{};
  told.x = estimate.position.x;
  told.y = estimate.position.y;
  told.ahead = direction_in_c(estimate.ahead);
  told.slip = estimate.slip;
  told.speed = estimate.speed;
  told.turning = estimate.turning;
  for (std::size_t row = 0; row < 3; ++row)
    std::copy(estimate.covariance[row].begin(), estimate.covariance[row].end(), told.covariance[row]);
  return told;
}

PoseEstimate estimate_of(const labmouse_estimate& said) {
  PoseEstimate estimate = {
      {said.x, said.y}, {said.ahead.sine, said.ahead.cosine}, said.slip, said.speed, said.turning, {}};
  for (std::size_t row = 0; row < 3; ++row) std::copy_n(said.covariance[row], 3, estimate.covariance[row].begin());
  return estimate;
}

/// All three parts; parts() offers only those for which the table has functions.
class TableOfParts final : public PartsOwner, EstimatorPart, ReaderPart, TrackerPart {
 public:
  TableOfParts(const struct labmouse_parts& table, const ControllerBriefing& briefing)
      : table_(table), told_(briefing_in_c(briefing)), memory_(table.begin ? table.begin(&told_) : nullptr) {}
  TableOfParts(const TableOfParts&) = delete;
  TableOfParts& operator=(const TableOfParts&) = delete;
  ~TableOfParts() override {
    if (table_.end) table_.end(memory_);
  }

  ControllerParts parts() override {
    ControllerParts parts;
    if (table_.estimate) parts.estimator = this;
    if (table_.evidence) parts.reader = this;
    if (table_.follow) parts.tracker = this;
    return parts;
  }

  void put(const Position& position, const Direction& ahead) override {
    if (table_.put) table_.put(memory_, position.x, position.y, direction_in_c(ahead));
  }
  PoseEstimate estimate(const Sense& sense, const Target& target, const Knowledge*) override {
    const labmouse_sense read = sense_in_c(sense);
    const labmouse_target should = target_in_c(target);
    return estimate_of(table_.estimate(memory_, &read, &should));
  }

  void begin(const Pose& pose) override {
    if (table_.look) table_.look(memory_, {pose.cell.x, pose.cell.y}, static_cast<labmouse_heading>(pose.heading));
  }
  void read(const Sense& sense, const PoseEstimate& estimate) override {
    if (!table_.read) return;
    const labmouse_sense read = sense_in_c(sense);
    const labmouse_estimate at = estimate_in_c(estimate);
    table_.read(memory_, &read, &at);
  }
  WallEvidence evidence(const PoseEstimate& estimate) const override {
    const labmouse_estimate at = estimate_in_c(estimate);
    const labmouse_evidence said = table_.evidence(memory_, &at);
    const auto cut = [](int number) { return static_cast<Evidence>(std::clamp(number, -127, 127)); };
    return {cut(said.left), cut(said.ahead), cut(said.right)};
  }

  void reset() override {
    if (table_.rest) table_.rest(memory_);
  }
  Drive follow(const Sense& sense, const Target& target, const PoseEstimate& estimate) override {
    const labmouse_sense read = sense_in_c(sense);
    const labmouse_target should = target_in_c(target);
    const labmouse_estimate at = estimate_in_c(estimate);
    const labmouse_duties said = table_.follow(memory_, &read, &should, &at);
    const auto duty = [](std::int32_t number) {
      return static_cast<float>(std::clamp<std::int32_t>(number, -ControllerTick::full, ControllerTick::full)) /
             static_cast<float>(ControllerTick::full);
    };
    return {duty(said.left), duty(said.right)};
  }

 private:
  const struct labmouse_parts& table_;
  labmouse_briefing told_;
  void* memory_;
};

}  // namespace

std::unique_ptr<PartsOwner> parts_in_c(const struct labmouse_parts& table, const ControllerBriefing& briefing) {
  return std::make_unique<TableOfParts>(table, briefing);
}

}  // namespace labmouse
