// The bounds of a few starts, which all searches for routes of a robot share.
#pragma once

#include <array>
#include <atomic>
#include <memory>

#include "labmouse/grid/cell.hpp"
#include "labmouse/mouse/drive/lists.hpp"

namespace labmouse::drive {

/// May be used by many at once: who finds none works them out and keeps them, which are the same whoever does it.
template <int Nodes>
class KeptBounds {
 public:
  /// Takes the memory for all that it will keep; without this nothing is kept.
  void start_keeping() { kept_ = std::make_unique<std::array<Kept, 8>>(); }

  /// Those of a start in a maze of that size, or null.
  const Bounds<Nodes>* find(Size size, int start) const {
    if (kept_ == nullptr) return nullptr;
    for (const Kept& kept : *kept_)
      if (kept.state.load(std::memory_order_acquire) == State::kept && kept.size == size && kept.start == start)
        return &kept.bounds;
    return nullptr;
  }
  /// Keeps them, where there is room and nobody else is just doing that.
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
