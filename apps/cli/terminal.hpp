// Terminals and signals, in which systems differ; terminal.cpp alone knows how.
#pragma once

#include <cstdio>
#include <optional>
#include <span>

namespace labmouse::cli {

/// Whether somebody looks at what is written there.
bool is_terminal(std::FILE* stream);

struct TerminalSize {
  int columns = 0, rows = 0;
};

/// Of the terminal that shows standard output; nothing where that is none, or does not say.
std::optional<TerminalSize> terminal_size();

/// The signals by which a user or the system asks a program to end: Ctrl-C, `kill`, a terminal that closes.
std::span<const int> ending_signals();
/// Whether it is that of a terminal that closes.
bool is_hangup(int signal);

/// From now on, what cannot be written, since its reader left (`| head`) or a file would grow beyond `ulimit -f`, shows
/// as a failed write.
void let_writes_fail();

}  // namespace labmouse::cli
