// Decorators of strategies: they forward calls to another strategy.
#pragma once

#include <cstdint>
#include <optional>

#include "labmouse/mouse/driving_strategy.hpp"

namespace labmouse {

/// Forwards the calls of Strategy to another one, which must outlive it.
template <class Kind>
class Forwarding : public Kind {
 public:
  explicit Forwarding(Kind& mouse) : mouse_(mouse) {}

  Action decide(const Sighting& seen) override { return mouse_.decide(seen); }
  const Knowledge& knowledge() const override { return mouse_.knowledge(); }
  StrategyReport report() override { return mouse_.report(); }
  const Reasons* reasons() const override { return mouse_.reasons(); }

 protected:
  Kind& mouse() const { return mouse_; }

 private:
  Kind& mouse_;
};

/// Forwards every call to another strategy. A class derived from it overrides what it changes.
class ForwardingStrategy : public Forwarding<Strategy> {
 public:
  using Forwarding::Forwarding;
};

/// The same in the worlds in seconds.
class ForwardingDriver : public Forwarding<DrivingStrategy> {
 public:
  using Forwarding::Forwarding;

  Action consider(const LogOddsMap& map, const SearchPlace& place, std::int64_t time) override {
    return mouse().consider(map, place, time);
  }
  void show(const Pose& pose, const Sighting& seen) override { mouse().show(pose, seen); }
  void carried(std::int64_t time) override { mouse().carried(time); }
  double pace(bool fast) override { return mouse().pace(fast); }
  void searches_at(double pace) override { mouse().searches_at(pace); }
  std::optional<MapKind> map_kind() const override { return mouse().map_kind(); }
  std::int64_t plans() const override { return mouse().plans(); }
};

}  // namespace labmouse
