// A controller that replays the recorded output of another.
#pragma once

#include <utility>
#include <vector>

#include "labmouse/contest/controller_code.hpp"

namespace labmouse {

/// Replays the tape, then gives up for that reason.
class TapedCode final : public ControllerCode {
 public:
  TapedCode(std::vector<ControllerTick> tape, ForfeitReason reason) : tape_(std::move(tape)), reason_(reason) {}

  ControllerTick tick(const Sense&) override {
    return next_ < tape_.size() ? tape_[next_++] : ControllerTick{0, 0, ControllerWord::give_up};
  }
  ForfeitReason reason() const override { return reason_; }

 private:
  std::vector<ControllerTick> tape_;
  ForfeitReason reason_;
  std::size_t next_ = 0;
};

}  // namespace labmouse
