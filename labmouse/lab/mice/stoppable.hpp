// Wrappers that end a contest when the user stops it.
#pragma once

#include <atomic>
#include <cstdint>

#include "labmouse/mouse/forwarding_strategy.hpp"

namespace labmouse {

/// Whether the flag, which may be null, is set.
inline bool is_set(const std::atomic<bool>* stop) { return stop != nullptr && stop->load(std::memory_order_relaxed); }

/// Forwards to a strategy, which must outlive it, and checks a flag before each decision. If it is set, the contest
/// ends as a forfeit with the reason `interrupted`.
class Stoppable final : public ForwardingStrategy {
 public:
  /// @param stop The flag; may be null.
  Stoppable(Strategy& mouse, const std::atomic<bool>* stop) : ForwardingStrategy(mouse), stop_(stop) {}

  Action decide(const Sighting& seen) override {
    return is_set(stop_) ? Action::forfeit(ForfeitReason::interrupted) : mouse().decide(seen);
  }

 private:
  const std::atomic<bool>* stop_;
};

/// The same for worlds in seconds.
class StoppableDriver final : public ForwardingDriver {
 public:
  StoppableDriver(DrivingStrategy& mouse, const std::atomic<bool>* stop) : ForwardingDriver(mouse), stop_(stop) {}

  Action decide(const Sighting& seen) override {
    return is_set(stop_) ? Action::forfeit(ForfeitReason::interrupted) : mouse().decide(seen);
  }
  Action consider(const LogOddsMap& map, const SearchPlace& place, std::int64_t time) override {
    return is_set(stop_) ? Action::forfeit(ForfeitReason::interrupted) : mouse().consider(map, place, time);
  }

 private:
  const std::atomic<bool>* stop_;
};

}  // namespace labmouse
