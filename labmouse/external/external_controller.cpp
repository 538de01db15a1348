#include "labmouse/external/external_controller.hpp"

#include "labmouse/external/controller_protocol.hpp"

namespace labmouse {

ExternalController::ExternalController(const Launch& launch, std::string_view briefing)
    : talk_(launch, controller_greeting) {
  const auto line = talk_.greet(briefing);
  if (!line) return;
  if (const auto verdict = judge_controller_greeting(*line))
    talk_.give_up(*verdict);
  else
    talk_.accept();
}

ControllerTick ExternalController::tick(const Sense& sense) {
  add_sense(sense, senses_);
  if (next_ == ticks_.size()) {
    constexpr ControllerTick nothing = {0, 0, ControllerWord::give_up};
    const auto line = talk_.ask(events_ + "sense" + senses_ + "\n");
    events_.clear();
    senses_.clear();
    ticks_.clear();
    next_ = 0;
    if (!line) return nothing;
    DutiesAnswer answer = judge_duties(*line, talk_.rest());
    if (answer.verdict) {
      talk_.give_up(*answer.verdict);
      return nothing;
    }
    ticks_ = std::move(answer.ticks);
  }
  return ticks_[next_++];
}

void ExternalController::carried(bool crashed) {
  events_ += crashed ? "carried crash\n" : "carried wish\n";
  senses_.clear();
  ticks_.clear();
  next_ = 0;
}

}  // namespace labmouse
