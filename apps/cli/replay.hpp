// What `labmouse replay` shows of a record, and `labmouse run` of the one that it has just made.
#pragma once

#include <string>

#include "command.hpp"
#include "explain.hpp"

namespace labmouse::cli {

struct ReplayOptions {
  std::string file, maze, svg;
  ExplainOptions explain;
  /// What is printed for --explain of a record without reasons.
  std::string no_reasons = "The record has no reasons; to keep them, use `labmouse run` with --explain and --record.";
  bool watch = false;
  int delay = 60;
};

/// Adds --watch and --delay.
void add_watch(Command& command, bool& watch, int& delay);

/// Plays a record again, whose text is given, and shows it; returns the exit code.
int show_replay(const ReplayOptions& options, const std::string& text);

}  // namespace labmouse::cli
