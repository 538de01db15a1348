#pragma once

#include "labmouse/mouse/forwarding_strategy.hpp"
#include "tests/strategies/allocations.hpp"

namespace labmouse::test {

/// Counts what deciding takes from the heap.
class CountingMouse : public ForwardingStrategy {
 public:
  using ForwardingStrategy::ForwardingStrategy;

  Action decide(const Sighting& seen) override {
    const long before = test::allocations();
    const Action action = mouse().decide(seen);
    allocations_ += test::allocations() - before;
    return action;
  }
  long allocations() const { return allocations_; }

 private:
  long allocations_ = 0;
};

}  // namespace labmouse::test
