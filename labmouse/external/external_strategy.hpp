// A strategy that runs as another program, and is asked by a line protocol.
#pragma once

#include "labmouse/external/talk.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// Starts the program, exchanges greetings, then asks it at each step. A program that violates the protocol or a limit
/// is ended, and forfeits with that reason.
class ExternalStrategy final : public Strategy {
 public:
  ExternalStrategy(const Launch& launch, const Briefing& briefing);

  Action decide(const Sighting& seen) override;
  /// Empty: the map of an external mouse is not visible.
  const Knowledge& knowledge() const override { return knowledge_; }
  StrategyReport report() override { return {.last_words = talk_.last_words(), .started = talk_.greeted()}; }

 private:
  Knowledge knowledge_;
  ExternalTalk talk_;
};

}  // namespace labmouse
