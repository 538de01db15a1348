#pragma once

#include "labmouse/mouse/forwarding_strategy.hpp"
#include "tests/strategies/allocations.hpp"

namespace labmouse::test {

/// Counts what deciding takes from the heap.
template <class Forwarder>
class Counting : public Forwarder {
 public:
  using Forwarder::Forwarder;

  Action decide(const Sighting& seen) override {
    const long before = test::allocations();
    const Action action = Forwarder::decide(seen);
    allocations_ += test::allocations() - before;
    return action;
  }
  long allocations() const { return allocations_; }

 private:
  long allocations_ = 0;
};

class CountingMouse : public Counting<ForwardingStrategy> {
 public:
  using Counting::Counting;
};

class CountingDriver : public Counting<ForwardingDriver> {
 public:
  using Counting::Counting;
};

}  // namespace labmouse::test
