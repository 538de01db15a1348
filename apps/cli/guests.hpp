// Mice that are other programs: their limits, and who races.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "labmouse/guests/limits.hpp"
#include "labmouse/guests/mms/host.hpp"
#include "labmouse/lab/contestants.hpp"

namespace labmouse::cli {

/// Adds --start-limit, --decision-limit, --contest-limit, --memory and --cpu.
void add_guest_limits(CLI::App& command, GuestLimits& limits);

/// Adds --strict and --presses.
void add_mms_options(CLI::App& command, MmsOptions& options);

/// Who races, in both worlds: the mice of the SPECs, all of the roster where there is none; throws UsageError.
SpecResult find_mice(const std::vector<std::string>& specs, const GuestOptions& options);

}  // namespace labmouse::cli
