// Checks the lines of external mice, and words the messages, for the command line and the page.
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

/// The action of an answer; with a verdict if it forfeits.
struct Answer {
  Action action;
  std::optional<Verdict> verdict;
};

/// Checks the first line; nullopt if it is the greeting.
std::optional<Verdict> judge_greeting(std::string_view line);

/// Checks an answer, a line without its end. `more`: what the mouse wrote after it, which should be empty.
Answer judge_answer(std::string_view line, std::string_view more);

/// It wrote more after its answer.
Verdict wrote_more(std::string_view answer, std::string_view more);

/// It wrote a line of more than `longest` bytes, which begins with `line`.
Verdict too_long(std::size_t longest, std::string_view line);

/// It wrote no line for that time, such as "2 s". `begun`: its incomplete line. `beginning`: what should have happened,
/// such as "the Robot of robot.py was made"; empty for the greeting.
Verdict hung(std::string_view time, bool greeted, std::string_view begun, std::string_view beginning = "");

/// It ended, `how` such as "exit code 1"; `greeting` is its expected first line.
Verdict ended_early(std::string_view how, bool greeted, std::string_view beginning = "",
                    std::string_view greeting = program_greeting);

/// Text that is kept of an external mouse that was given up: the sentence, and the end of its standard error.
std::string last_words_of(std::string_view sentence, std::string_view errors);

}  // namespace labmouse
