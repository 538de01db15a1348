// An external controller: a program that gets sensor readings, and answers with motor duties.
#pragma once

#include <string>
#include <vector>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/controller/speed_control.hpp"
#include "labmouse/external/controller_protocol.hpp"
#include "labmouse/external/talk.hpp"

namespace labmouse {

/// Starts the program, exchanges greetings, then asks it whenever all its duties are used. A program that violates the
/// protocol or a limit is ended, and gives up with that reason.
class ExternalController final : public ControllerCode {
 public:
  /// @param briefing the lines from the greeting to `begin`.
  /// @param inner_loop drives at the speeds of a program that does not answer with duties.
  ExternalController(const Launch& launch, std::string_view briefing, SpeedControl inner_loop);

  ControllerTick tick(const Sense& sense) override;
  void carried(bool crashed) override;
  ForfeitReason reason() const override { return talk_.reason(); }
  bool started() const override { return talk_.greeted(); }
  std::string_view last_words() override { return talk_.last_words(); }

 private:
  ExternalTalk talk_;
  SpeedControl inner_loop_;
  AnswerUnits units_ = AnswerUnits::duties;
  std::string events_, senses_;        ///< not yet sent to it
  std::vector<ControllerTick> ticks_;  ///< of its last answer, in its units
  std::size_t next_ = 0;
};

}  // namespace labmouse
