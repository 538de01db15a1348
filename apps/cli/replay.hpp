// What `labmouse replay` shows of a record, and `labmouse run` of the one that it has just made.
#pragma once

#include <string>

#include "command.hpp"
#include "explain.hpp"

namespace labmouse::cli {

struct ReplayOptions {
  const Command* command = nullptr;
  std::string file, maze, svg;
  ExplainOptions explain;
  bool watch = false;
  int delay = 60;
};

/// Adds --watch and --delay.
void add_watch(Command& command, bool& watch, int& delay);

/// Plays a record again, whose text is given, and shows it; returns the exit code.
int replay_text(const ReplayOptions& options, const std::string& text);

}  // namespace labmouse::cli
