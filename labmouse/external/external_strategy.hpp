// A mouse that is another program: it is asked by lines, and answers by lines.
#pragma once

#include "labmouse/external/talk.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// Starts the program and greets it, then asks it at each step. A program that does not play by the protocol or its
/// limits is ended, and what it did is a forfeit with that reason.
class ExternalStrategy final : public Strategy {
 public:
  ExternalStrategy(const Launch& launch, const Briefing& briefing);

  Action decide(const Sighting& seen) override;
  /// Nothing: what an external mouse believes nobody sees.
  const Knowledge& knowledge() const override { return knowledge_; }
  StrategyReport report() override { return {.last_words = talk_.last_words(), .started = talk_.greeted()}; }

 private:
  Knowledge knowledge_;
  ExternalTalk talk_;
};

}  // namespace labmouse
