// Storage for the bounds of a few starts (least times from there), shared by all searches for routes of a robot.
#pragma once

#include <array>
#include <atomic>
#include <memory>

#include "labmouse/grid/cell.hpp"
#include "labmouse/mouse/drive/lists.hpp"

namespace labmouse::drive {

/// Several threads may use it at once. A search that finds no bounds computes and keeps them; all compute the same.
template <int Nodes>
class KeptBounds {
 public:
  /// Allocates the storage; before that nothing is kept.
  void start_keeping() { kept_ = std::make_unique<std::array<Kept, 8>>(); }

  /// The bounds of a start in a maze of that size, or null.
  const Bounds<Nodes>* find(Size size, int start) const {
    if (kept_ == nullptr) return nullptr;
    for (const Kept& kept : *kept_)
      if (kept.state.load(std::memory_order_acquire) == State::kept && kept.size == size && kept.start == start)
        return &kept.bounds;
    return nullptr;
  }
  /// Keeps them, if there is room and no other thread is just keeping some.
  void keep(Size size, int start, const Bounds<Nodes>& bounds) {
    if (kept_ == nullptr) return;
    for (Kept& kept : *kept_) {
      State state = State::free;
      if (kept.state.compare_exchange_strong(state, State::written, std::memory_order_acq_rel)) {
        kept.size = size;
        kept.start = start;
        kept.bounds = bounds;
        kept.state.store(State::kept, std::memory_order_release);
        return;
      }
      if (state == State::written || (kept.size == size && kept.start == start)) return;
    }
  }

 private:
  enum class State : int { free, written, kept };
  struct Kept {
    std::atomic<State> state = State::free;
    Size size{};
    int start = 0;
    Bounds<Nodes> bounds;
  };

  std::unique_ptr<std::array<Kept, 8>> kept_;
};

}  // namespace labmouse::drive
