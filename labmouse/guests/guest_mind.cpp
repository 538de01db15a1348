#include "labmouse/guests/guest_mind.hpp"

#include "labmouse/guests/protocol.hpp"

namespace labmouse {

GuestMind::GuestMind(const Launch& launch, const Briefing& briefing)
    : knowledge_(briefing.size), talk_(launch, guest_greeting) {
  const auto line = talk_.greet(briefing_text(briefing));
  if (!line) return;
  if (const auto verdict = judge_greeting(*line))
    talk_.give_up(*verdict);
  else
    talk_.accept();
}

Action GuestMind::decide(const Sighting& seen) {
  const auto line = talk_.ask(question(seen));
  if (!line) return Action::forfeit(talk_.reason());
  const Answer answer = judge_answer(*line, talk_.rest());
  if (answer.verdict) talk_.give_up(*answer.verdict);
  return answer.action;
}

}  // namespace labmouse
