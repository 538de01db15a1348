// A mouse whose whole program is another one: it is sent what its sensors read, and answers with the duties of its
// motors.
#pragma once

#include <string>
#include <vector>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/external/talk.hpp"

namespace labmouse {

/// Starts the program and greets it, then asks it whenever all duties that it gave are driven. One that does not play
/// by the protocol or its limits is ended, and gives up with that reason.
class ExternalController final : public ControllerCode {
 public:
  /// `briefing`: the lines from the greeting to `begin`.
  ExternalController(const Launch& launch, std::string_view briefing);

  ControllerTick tick(const Sense& sense) override;
  void carried(bool crashed) override;
  ForfeitReason reason() const override { return talk_.reason(); }
  bool started() const override { return talk_.greeted(); }
  std::string_view last_words() override { return talk_.last_words(); }

 private:
  ExternalTalk talk_;
  std::string events_, senses_;        ///< that it has not got yet
  std::vector<ControllerTick> ticks_;  ///< that it answered
  std::size_t next_ = 0;
};

}  // namespace labmouse
