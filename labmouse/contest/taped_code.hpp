// A program that says again what one said: for records.
#pragma once

#include <utility>
#include <vector>

#include "labmouse/contest/pilot_code.hpp"

namespace labmouse {

/// Says what is on the tape, and then gives up, for that reason.
class TapedCode final : public PilotCode {
 public:
  TapedCode(std::vector<PilotTick> tape, ForfeitReason reason) : tape_(std::move(tape)), reason_(reason) {}

  PilotTick tick(const Sense&) override {
    return next_ < tape_.size() ? tape_[next_++] : PilotTick{0, 0, PilotWord::give_up};
  }
  ForfeitReason reason() const override { return reason_; }

 private:
  std::vector<PilotTick> tape_;
  ForfeitReason reason_;
  std::size_t next_ = 0;
};

}  // namespace labmouse
