// A strategy in front of another one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// Forwards every call to another strategy, which must outlive it. A class derived from it overrides what it changes.
class ForwardingStrategy : public Strategy {
 public:
  explicit ForwardingStrategy(Strategy& mouse) : mouse_(mouse) {}

  Action decide(const Sighting& seen) override { return mouse_.decide(seen); }
  void show(const Pose& pose, const Sighting& seen) override { mouse_.show(pose, seen); }
  void carried(std::int64_t time) override { mouse_.carried(time); }
  bool considers() const override { return mouse_.considers(); }
  Action consider(const Belief& belief, const SearchPlace& place, std::int64_t time) override {
    return mouse_.consider(belief, place, time);
  }
  double pace(bool fast) override { return mouse_.pace(fast); }
  void searches_at(double pace) override { mouse_.searches_at(pace); }
  std::optional<MapKind> map_kind() const override { return mouse_.map_kind(); }
  const Knowledge& knowledge() const override { return mouse_.knowledge(); }
  std::span<const Counter> counters() const override { return mouse_.counters(); }
  std::string_view last_words() override { return mouse_.last_words(); }
  std::optional<double> microseconds() const override { return mouse_.microseconds(); }
  bool started() const override { return mouse_.started(); }
  void keep_reasons() override { mouse_.keep_reasons(); }
  const Reasons* reasons() const override { return mouse_.reasons(); }

 protected:
  Strategy& mouse() const { return mouse_; }

 private:
  Strategy& mouse_;
};

}  // namespace labmouse
