#include "labmouse/external/dialogue.hpp"

#include <fmt/format.h>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/external/protocol.hpp"

namespace labmouse {

Dialogue::Dialogue(const Maze& maze, const Rules& rules, std::uint64_t seed)
    : lines_(limits_.longest_line), to_say_(briefing_text(brief(maze, rules, seed))), contest_(maze, rules) {}

void Dialogue::hear(std::string_view output) {
  lines_.append(output);
  while (!contest_.ended()) {
    const auto line = lines_.next();
    if (lines_.too_long()) return give_up(too_long(limits_.longest_line, lines_.rest()));
    if (!line) return;
    hear_line(*line);
  }
}

void Dialogue::hear_errors(std::string_view errors) {
  errors_ += errors;
  if (errors_.size() > limits_.kept_errors) errors_.erase(0, errors_.size() - limits_.kept_errors);
}

void Dialogue::hear_line(std::string_view line) {
  if (!greeted_) {
    if (const auto verdict = judge_greeting(line)) return give_up(*verdict);
    greeted_ = true;
    return ask();
  }
  const Answer answer = judge_answer(line, lines_.rest());
  if (answer.verdict) return give_up(*answer.verdict);
  contest_.act(answer.action);
  ask();
}

void Dialogue::ask() {
  if (!contest_.ended()) to_say_ += question(contest_.sighting());
}

void Dialogue::give_up(const ProgramEnd& end) {
  if (contest_.ended()) return;
  switch (end.kind) {
    case ProgramEnd::Kind::exited:
      return give_up(ended_early(end.what, greeted_));
    case ProgramEnd::Kind::silent:
      return give_up(hung(end.what, greeted_, lines_.rest()));
    case ProgramEnd::Kind::printed:
      return give_up({ForfeitReason::too_much_written, "it wrote " + end.what});
    case ProgramEnd::Kind::interrupted:
      return give_up({ForfeitReason::interrupted, "it was interrupted"});
  }
}

void Dialogue::give_up(const Verdict& verdict) {
  sentence_ = verdict.sentence;
  to_say_.clear();
  contest_.act(Action::forfeit(verdict.reason));
}

RunRecord Dialogue::take_record() {
  RunRecord record = contest_.take_record();
  record.last_words = sentence_.empty() ? errors_ : last_words_of(sentence_, errors_);
  return record;
}

}  // namespace labmouse
