// A mouse that plays a prepared list of actions and then forfeits.
#pragma once

#include <utility>
#include <vector>

#include "labmouse/mouse/strategy.hpp"

namespace labmouse::test {

class PreparedMouse final : public Strategy {
 public:
  PreparedMouse(Size size, std::vector<Action> actions) : knowledge_(size), actions_(std::move(actions)) {}

  Action decide(const Sighting&) override {
    return next_ < actions_.size() ? actions_[next_++] : Action::forfeit(ForfeitReason::finished);
  }
  const Knowledge& knowledge() const override { return knowledge_; }

 private:
  Knowledge knowledge_;
  std::vector<Action> actions_;
  std::size_t next_ = 0;
};

}  // namespace labmouse::test
