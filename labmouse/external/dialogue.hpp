// A contest of an external mouse whose program the caller runs, such as the page. The caller passes lines between this
// object and the program.
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

/// How a program ended too early, or was ended.
struct ProgramEnd {
  enum class Kind : std::uint8_t {
    exited,      ///< `what` says how: "exit code 1"
    silent,      ///< it did not answer; `what` says how long: "2 s"
    printed,     ///< it wrote too much; `what` says how much: "more than 1000 lines"
    interrupted  ///< the user stopped it
  };
  Kind kind = Kind::exited;
  std::string what;
};

/// Gives the same record as ExternalStrategy with a program that gives the same answers.
class Dialogue {
 public:
  Dialogue(const Maze& maze, const Rules& rules, std::uint64_t seed);
  Dialogue(const Dialogue&) = delete;
  Dialogue& operator=(const Dialogue&) = delete;

  /// Returns the lines to write to the program, first the briefing, and clears them.
  std::string take_lines() { return std::exchange(to_say_, ""); }
  /// Takes the program's standard output, in pieces of any size, and its standard error.
  void hear(std::string_view output);
  void hear_errors(std::string_view errors);
  /// Ends the contest, because the program ended.
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
  std::string sentence_;  ///< why the program was given up
  Contest contest_;
};

}  // namespace labmouse
