// The interface of every mouse.
#pragma once

#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

/// A mind. It is called and never calls, so one object serves a loop, a browser frame and an interrupt.
class Strategy {
 public:
  virtual ~Strategy() = default;

  /// The next action, given what is read in the present pose. Called once a step until the contest ends.
  virtual Action decide(const Sighting& seen) = 0;

  /// What the mouse believes, for viewers and for the contract tests.
  virtual const Knowledge& knowledge() const = 0;
};

}  // namespace labmouse
