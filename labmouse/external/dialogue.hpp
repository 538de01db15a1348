// A contest of an external mouse whose program somebody else runs: it gets what to write to the program, and hears
// what that said.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "labmouse/contest/contest.hpp"
#include "labmouse/external/limits.hpp"
#include "labmouse/external/line_buffer.hpp"
#include "labmouse/external/verdict.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// How a program ended that should not have, or was ended.
struct ProgramEnd {
  enum class Kind : std::uint8_t {
    died,        ///< `what` is how: "exit code 1"
    silent,      ///< `what` is for how long: "2 s"
    printed,     ///< it wrote too much, of which `what` tells: "more than 1000 lines"
    interrupted  ///< somebody stopped it
  };
  Kind kind = Kind::died;
  std::string what;
};

/// The same contest, word for word, as of a ExternalStrategy whose program says the same.
class Dialogue {
 public:
  Dialogue(const Maze& maze, const Rules& rules, std::uint64_t seed);
  Dialogue(const Dialogue&) = delete;
  Dialogue& operator=(const Dialogue&) = delete;

  /// What is to be said to the program: whole lines, at first the briefing. Each is given once.
  std::string take_lines() { return std::exchange(to_say_, ""); }
  /// What it wrote to its standard output, in pieces of any size, and to its standard error.
  void hear(std::string_view output);
  void hear_errors(std::string_view errors);
  /// The program is no more.
  void give_up(const ProgramEnd& end);

  const Contest& contest() const { return contest_; }
  bool greeted() const { return greeted_; }
  /// The record, once the contest has ended.
  RunRecord take_record();

 private:
  void hear_line(std::string_view line);
  void ask();
  void give_up(const Verdict& verdict);

  ExternalLimits limits_;
  LineBuffer lines_;
  std::string errors_, to_say_;
  bool greeted_ = false;
  std::string sentence_;  ///< why it was given up
  Contest contest_;
};

}  // namespace labmouse
