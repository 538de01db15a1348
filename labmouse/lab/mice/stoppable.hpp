// A strategy that decides no more once its contest is stopped.
#pragma once

#include <atomic>
#include <cstdint>

#include "labmouse/mouse/forwarding_strategy.hpp"

namespace labmouse {

/// Stands in front of a strategy, which must outlive it, and asks before each of its decisions. A contest that was
/// stopped ends as a forfeit, interrupted.
class Stoppable final : public ForwardingStrategy {
 public:
  /// `stop` may be null: then nothing stops it.
  Stoppable(Strategy& mouse, const std::atomic<bool>* stop) : ForwardingStrategy(mouse), stop_(stop) {}

  Action decide(const Sighting& seen) override {
    return stopped() ? Action::forfeit(ForfeitReason::interrupted) : mouse().decide(seen);
  }
  Action consider(const Belief& belief, const SearchPlace& place, std::int64_t time) override {
    return stopped() ? Action::forfeit(ForfeitReason::interrupted) : mouse().consider(belief, place, time);
  }

 private:
  bool stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }

  const std::atomic<bool>* stop_;
};

}  // namespace labmouse
