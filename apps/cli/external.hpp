// Options of mice that are external programs: how they start, and their limits.
#pragma once

#include "labmouse/lab/mice/contestant.hpp"
#include "options.hpp"

namespace labmouse::cli {

/// Adds the limits of programs, such as --start-limit, --memory and --cpu.
void add_limits(Command& command, ExternalLimits& limits);

/// Adds --directory, --sandbox, --keep-folder and the limits of programs, such as --start-limit, --memory and --cpu.
void add_external_options(Command& command, ExternalOptions& external_mice);

/// Adds --python and --board, which say what runs a file.
void add_runners(Command& command, ExternalOptions& external_mice);

/// Adds all of these, and --label, for commands that run programs and may store their contests.
void add_program_options(Command& command, ExternalOptions& external_mice);

/// Adds all of these, and --external-runs, for commands that run several contests in a maze.
void add_racing_options(Command& command, ExternalOptions& external_mice);

}  // namespace labmouse::cli
