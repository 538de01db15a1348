#include "explain.hpp"

#include "command.hpp"

namespace labmouse::cli {

void add_explain(Command& command, ExplainOptions& options) {
  Option* flag = command.add_flag(
      "--explain", options.wanted,
      "Show which walls the mouse chose from, and why it stopped; of a record in seconds, what happened");
  command.add_option("--candidates", options.candidates, "Number of candidates that --explain shows for each choice")
      ->needs(flag)
      ->check(in_range(1, 10'000))
      ->capture_default_str();
}

}  // namespace labmouse::cli
