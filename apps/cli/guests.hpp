// Mice that are other programs: how they are started, and their limits.
#pragma once

#include "labmouse/lab/mice/contestant.hpp"
#include "options.hpp"

namespace labmouse::cli {

/// Adds --directory, --start-limit, --decision-limit, --silence-limit, --contest-limit, --memory and --cpu.
void add_guest_options(Command& command, GuestOptions& guests);

/// Adds --python.
void add_python(Command& command, GuestOptions& guests);

/// All of these, and --guest-runs, for commands that hold many contests.
void add_racing_guests(Command& command, GuestOptions& guests);

}  // namespace labmouse::cli
