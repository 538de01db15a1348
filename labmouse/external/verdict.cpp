#include "labmouse/external/verdict.hpp"

#include <fmt/format.h>

#include "labmouse/external/quoted_line.hpp"

namespace labmouse {
namespace {

/// A text without line ends at its end.
std::string_view without_end(std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

Answer forfeit(ForfeitReason reason, std::string sentence) {
  return {Action::forfeit(reason), Verdict{reason, std::move(sentence)}};
}

}  // namespace

std::optional<Verdict> judge_greeting(std::string_view line) {
  if (line == program_greeting) return std::nullopt;
  const char* hint = line == "mazeWidth" || line == "mazeHeight" || line.starts_with("wall")
                         ? "; it seems to be written for mms; race it as mms:COMMAND"
                         : "";
  return Verdict{ForfeitReason::invalid_answer,
                 fmt::format("its first line is {} instead of '{}'{}", quoted_line(line), program_greeting, hint)};
}

Answer judge_answer(std::string_view line, std::string_view more) {
  const auto action = read_answer(line);
  if (!action)
    return forfeit(
        ForfeitReason::invalid_answer,
        fmt::format("it answered {} instead of `move ROTATION MOVEMENT`, `reset` or `forfeit`", quoted_line(line)));
  if (!more.empty()) {
    Verdict verdict = wrote_more(line, more);
    return forfeit(verdict.reason, std::move(verdict.sentence));
  }
  if (action->kind == Action::Kind::forfeit) return forfeit(action->reason, "it answered `forfeit`");
  return {*action, std::nullopt};
}

Verdict wrote_more(std::string_view answer, std::string_view more) {
  return {ForfeitReason::flooded, fmt::format("after its answer {} it wrote more: {}", quoted_line(answer),
                                              quoted_line(more.substr(0, more.find('\n'))))};
}

Verdict too_long(std::size_t longest, std::string_view line) {
  return {ForfeitReason::flooded, fmt::format("it wrote a line of more than {} bytes: {}", longest, quoted_line(line))};
}

Verdict hung(std::string_view time, bool greeted, std::string_view begun, std::string_view beginning) {
  std::string behind;
  if (!begun.empty())
    behind = fmt::format("; it wrote {} without ending the line", quoted_line(begun));
  else if (!greeted)
    behind = beginning.empty() ? "; does it flush after each line?" : fmt::format(" before {}", beginning);
  return {ForfeitReason::hung, fmt::format("it was silent for {}{}", time, behind)};
}

Verdict ended_early(std::string_view how, bool greeted, std::string_view beginning, std::string_view greeting) {
  std::string before;
  if (!greeted)
    before = beginning.empty() ? fmt::format(" before it wrote '{}'", greeting) : fmt::format(" before {}", beginning);
  return {ForfeitReason::ended_early, fmt::format("it ended with {}{}", how, before)};
}

std::string last_words_of(std::string_view sentence, std::string_view errors) {
  errors = without_end(errors);
  return errors.empty() ? std::string(sentence) : fmt::format("{}\n{}", sentence, errors);
}

}  // namespace labmouse
