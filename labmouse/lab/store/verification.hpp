// Re-runs contests of a store and compares the results.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/lab/store/stored_races.hpp"

namespace labmouse {

/// The settings of a verification.
struct VerificationOrder {
  double share = 0.05;     ///< share of the contests that are picked at random, 0 to 1
  std::uint64_t seed = 1;  ///< seed of that random choice
  int jobs = 0;
  /// How external programs of the store are started. The sandbox is always on: without one, none starts.
  ExternalOptions external_mice = {};
  /// Called once for each SPEC of a program, before it is looked up or started. Without this function no program is
  /// run: a store may come from somebody else, so its programs are not the user's own.
  std::function<bool(const std::string& spec)> may_run = {};
  const std::atomic<bool>* stop = nullptr;  ///< once true, no further contest begins
};

/// The result of a verification.
struct Verification {
  std::int64_t held = 0;                 ///< contests that were re-run
  std::int64_t equal = 0;                ///< those with the same result, apart from timings
  std::vector<std::string> differences;  ///< the others, a line each
  std::int64_t impossible = 0;           ///< picked contests whose mouse is not available here
  std::int64_t not_run = 0;              ///< picked contests whose program may not be run
  std::vector<std::string> programs;     ///< the SPECs of these programs
  bool stopped = false;                  ///< stopped before all picked contests were re-run
  std::vector<std::string> remarks;
  std::string error;  ///< why nothing could be verified, as a line for the user
};

/// Checks the whole file and re-runs a random sample of its contests. A mouse is available where its SPEC still gives
/// the same mouse: same build, same files. Runs only allowed programs, and only in a sandbox.
Verification verify_store(const std::string& path, const StoreFilter& filter, const VerificationOrder& order);

}  // namespace labmouse
