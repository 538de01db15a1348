#include "labmouse/external/external_controller.hpp"

#include <cmath>
#include <utility>

namespace labmouse {
namespace {

/// Duties in parts of ControllerTick::full.
ControllerTick tick_of(const Drive& drive, ControllerWord word) {
  const auto parts = [](float duty) { return static_cast<std::int16_t>(std::lround(duty * ControllerTick::full)); };
  return {parts(drive.left), parts(drive.right), word};
}

}  // namespace

ExternalController::ExternalController(const Launch& launch, std::string_view briefing, SpeedControl inner_loop)
    : talk_(launch, controller_greeting), inner_loop_(std::move(inner_loop)) {
  const auto line = talk_.greet(briefing);
  if (!line) return;
  const auto judged = judge_controller_greeting(*line);
  if (judged.verdict) {
    talk_.give_up(*judged.verdict);
    return;
  }
  units_ = judged.value;
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
  const ControllerTick& answer = ticks_[next_++];
  if (units_ == AnswerUnits::duties) return answer;
  return tick_of(inner_loop_.control(answer.left, answer.right / 1e3, sense), answer.word);
}

void ExternalController::carried(bool crashed) {
  events_ += crashed ? "carried crash\n" : "carried wish\n";
  senses_.clear();
  ticks_.clear();
  next_ = 0;
  inner_loop_.rest();
}

}  // namespace labmouse
