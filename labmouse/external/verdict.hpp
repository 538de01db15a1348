// What an external mouse said or left unsaid, judged: the same words for a program of the command line and for one of
// the page.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "labmouse/external/protocol.hpp"
#include "labmouse/mouse/action.hpp"

namespace labmouse {

/// Why an external mouse is given up, as a sentence for people.
struct Verdict {
  ForfeitReason reason = ForfeitReason::none;
  std::string sentence;
};

/// What to do by an answer; where it forfeits, there is a verdict.
struct Answer {
  Action action;
  std::optional<Verdict> verdict;
};

/// Nothing where its first line is the greeting.
std::optional<Verdict> judge_greeting(std::string_view line);

/// An answer, a line without its end, and what the external mouse wrote behind it, which should be nothing.
Answer judge_answer(std::string_view line, std::string_view more);

/// Behind its answer it wrote more.
Verdict wrote_more(std::string_view answer, std::string_view more);

/// It wrote a line of more than so many bytes, which begins so.
Verdict too_long(std::size_t longest, std::string_view line);

/// It was silent for that time, "2 s" or with the option that sets it. `begun`: what it wrote of a line. `beginning`:
/// what it should have come to, "the Robot of robot.py was made"; empty for the greeting.
Verdict hung(std::string_view time, bool greeted, std::string_view begun, std::string_view beginning = "");

/// It ended, with "exit code 1" or a word on its error; `greeting` is what it should have written first.
Verdict died(std::string_view how, bool greeted, std::string_view beginning = "",
             std::string_view greeting = program_greeting);

/// What is kept of an external mouse that was given up: the sentence, and the last that it wrote to its standard error.
std::string last_words_of(std::string_view sentence, std::string_view errors);

}  // namespace labmouse
