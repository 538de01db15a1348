#include "labmouse/external/external_strategy.hpp"

#include "labmouse/external/protocol.hpp"

namespace labmouse {

ExternalStrategy::ExternalStrategy(const Launch& launch, const Briefing& briefing)
    : knowledge_(briefing.size), talk_(launch, program_greeting) {
  const auto line = talk_.greet(briefing_text(briefing));
  if (!line) return;
  if (const auto verdict = judge_greeting(*line))
    talk_.give_up(*verdict);
  else
    talk_.accept();
}

Action ExternalStrategy::decide(const Sighting& seen) {
  const auto line = talk_.ask(question(seen));
  if (!line) return Action::forfeit(talk_.reason());
  const Answer answer = judge_answer(*line, talk_.rest());
  if (answer.verdict) talk_.give_up(*answer.verdict);
  return answer.action;
}

}  // namespace labmouse
