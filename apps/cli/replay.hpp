// Shows a record for `labmouse replay`, and for `labmouse run` after a contest.
#pragma once

#include <string>

#include "command.hpp"
#include "explain.hpp"

namespace labmouse::cli {

/// The options of `labmouse replay`; `delay` is in milliseconds.
struct ReplayOptions {
  std::string file, maze, svg, log;
  ExplainOptions explain;
  /// Printed for --explain where a record has no reasons.
  std::string no_reasons = "The record has no reasons; to keep them, use `labmouse run` with --explain and --record.";
  /// Whether the text is the record of a contest that was just run with external parts, which cannot be checked.
  bool has_parts = false;
  bool watch = false;
  int delay = 60;
};

/// Adds --log.
void add_log(Command& command, std::string& log);

/// Adds --watch and --delay.
void add_watch(Command& command, bool& watch, int& delay);

/// Replays a record from its text and shows it; returns the exit code.
int show_replay(const ReplayOptions& options, const std::string& text);

}  // namespace labmouse::cli
