// Mice that are other programs: how they are started, their limits, and who races.
#pragma once

#include <string>
#include <vector>

#include "labmouse/guests/mms/host.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "options.hpp"

namespace labmouse::cli {

/// Adds --directory, --start-limit, --decision-limit, --contest-limit, --memory and --cpu.
void add_guest_options(Command& command, GuestOptions& guests);

/// Adds --python.
void add_python(Command& command, GuestOptions& guests);

/// Adds --strict and --presses.
void add_mms_options(Command& command, MmsOptions& options);

/// Who races, in both worlds: the mice of the SPECs, all of the roster where there is none; throws UsageError.
SpecResult find_mice(const std::vector<std::string>& specs, const GuestOptions& options);

}  // namespace labmouse::cli
