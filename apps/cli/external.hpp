// Mice that are other programs: how they are started, and their limits.
#pragma once

#include "labmouse/lab/mice/contestant.hpp"
#include "options.hpp"

namespace labmouse::cli {

/// Adds --directory, --start-limit, --decision-limit, --silence-limit, --contest-limit, --memory and --cpu.
void add_external_options(Command& command, ExternalOptions& external_mice);

/// Adds --python.
void add_python(Command& command, ExternalOptions& external_mice);

/// All of these, and --external mouse-runs, for commands that hold many contests.
void add_racing_options(Command& command, ExternalOptions& external_mice);

}  // namespace labmouse::cli
