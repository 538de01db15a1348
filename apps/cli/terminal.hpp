// Terminals and signals. Only terminal.cpp knows the differences between systems.
#pragma once

#include <cstdio>
#include <optional>
#include <span>

namespace labmouse::cli {

/// Whether the stream is a terminal.
bool is_terminal(std::FILE* stream);

struct TerminalSize {
  int columns = 0, rows = 0;
};

/// The size of the terminal on standard output; nothing if it is no terminal, or its size is unknown.
std::optional<TerminalSize> terminal_size();

/// The signals that end a program: Ctrl-C, `kill`, and closing the terminal.
std::span<const int> ending_signals();
/// Whether it is the signal of a closed terminal.
bool is_hangup(int signal);

/// Makes writes fail instead of ending the program: where the reader has left (`| head`), or a file would exceed
/// `ulimit -f`.
void let_writes_fail();

}  // namespace labmouse::cli
