// Mice that are other programs: their limits, and who races.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "labmouse/guests/limits.hpp"
#include "labmouse/guests/mms/host.hpp"
#include "labmouse/lab/contestants.hpp"
#include "labmouse/lab/mms_mouse.hpp"

namespace labmouse::cli {

/// Adds --start-limit, --decision-limit, --contest-limit, --memory and --cpu.
void add_guest_limits(CLI::App& command, GuestLimits& limits);

/// Adds --strict and --presses.
void add_mms_options(CLI::App& command, MmsOptions& options);

/// The program of a command; throws UsageError where there is none.
Launch find_program(const std::string& command, const std::string& directory, const GuestLimits& limits);

/// Who races, in both worlds.
struct Mice {
  std::vector<Contestant> contestants;
  std::vector<MmsMouse> mms;
};

/// The mice of the SPECs, all of the roster where there is none; throws UsageError.
Mice find_mice(const std::vector<std::string>& specs, const GuestLimits& limits);

}  // namespace labmouse::cli
