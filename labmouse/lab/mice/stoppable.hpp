// A mind that decides no more once its contest is stopped.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <string_view>

#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// Stands before a mind, which must outlive it, and asks before each of its decisions. A contest that was stopped ends
/// as a forfeit, interrupted.
class Stoppable final : public Strategy {
 public:
  /// `stop` may be null: then nothing stops it.
  Stoppable(Strategy& mouse, const std::atomic<bool>* stop) : mouse_(mouse), stop_(stop) {}

  Action decide(const Sighting& seen) override {
    return stopped() ? Action::forfeit(ForfeitReason::interrupted) : mouse_.decide(seen);
  }
  void show(const Pose& pose, const Sighting& seen) override { mouse_.show(pose, seen); }
  void carried(std::int64_t time) override { mouse_.carried(time); }
  bool considers() const override { return mouse_.considers(); }
  Action consider(const Belief& belief, const SearchPlace& place, std::int64_t time) override {
    return stopped() ? Action::forfeit(ForfeitReason::interrupted) : mouse_.consider(belief, place, time);
  }
  double pace(bool fast) override { return mouse_.pace(fast); }
  std::optional<MapKind> map_kind() const override { return mouse_.map_kind(); }
  const Knowledge& knowledge() const override { return mouse_.knowledge(); }
  std::span<const Counter> counters() const override { return mouse_.counters(); }
  std::string_view last_words() override { return mouse_.last_words(); }
  bool started() const override { return mouse_.started(); }
  void keep_reasons() override { mouse_.keep_reasons(); }
  const Reasons* reasons() const override { return mouse_.reasons(); }

 private:
  bool stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }

  Strategy& mouse_;
  const std::atomic<bool>* stop_;
};

}  // namespace labmouse
