// A mouse that does what it is told, for tests of contests in seconds.
#pragma once

#include <utility>
#include <vector>

#include "labmouse/mouse/driving_strategy.hpp"

namespace labmouse::test {

class Scripted final : public DrivingStrategy {
 public:
  explicit Scripted(std::vector<Action> script) : script_(std::move(script)) {}

  Action decide(const Sighting& seen) override {
    read.push_back(seen);
    return next_ < script_.size() ? script_[next_++] : Action::forfeit(ForfeitReason::finished);
  }
  Action consider(const LogOddsMap& map, const SearchPlace& place, std::int64_t) override {
    return decide(map.sighting(place.pose));
  }
  void carried(std::int64_t) override {}
  void show(const Pose& pose, const Sighting& seen) override { shown.emplace_back(pose, seen); }
  const Knowledge& knowledge() const override { return knowledge_; }

  std::vector<Sighting> read;
  std::vector<std::pair<Pose, Sighting>> shown;

 private:
  std::vector<Action> script_;
  std::size_t next_ = 0;
  Knowledge knowledge_{Size{1, 1}};
};

}  // namespace labmouse::test
