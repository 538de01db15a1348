// Contests of a store run again, to see whether they come to what the store says.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/lab/store/stored_races.hpp"

namespace labmouse {

struct VerificationOrder {
  double share = 0.05;     ///< of the contests, 0 to 1, picked at random
  std::uint64_t seed = 1;  ///< of that choice
  int jobs = 0;
  /// How programs are started that the store names. Their sandbox is not a matter of choice: without one none starts.
  ExternalOptions external_mice = {};
  /// Asked once for each SPEC of a program, before anything of it is looked up or started; without an answer, no
  /// program is run. A store may come from somebody else, so its programs are not the user's own.
  std::function<bool(const std::string& spec)> may_run = {};
  const std::atomic<bool>* stop = nullptr;  ///< once true no other contest begins
};

struct Verification {
  std::int64_t held = 0;                 ///< contests that were run again
  std::int64_t equal = 0;                ///< those that came to the same, but for timings
  std::vector<std::string> differences;  ///< the others, a line each
  std::int64_t impossible = 0;           ///< contests that were picked and whose mouse is not here any more
  std::int64_t not_run = 0;              ///< contests that were picked and whose program was not to be run
  std::vector<std::string> programs;     ///< the SPECs of these programs
  bool stopped = false;                  ///< before all that were picked were run again
  std::vector<std::string> remarks;
  std::string error;  ///< why nothing could be verified, as a line for the user
};

/// Checks the file as a whole, and holds a share of its contests again. A mouse is here where its SPEC leads to the
/// same one: the same build, the same files. Runs no program that nobody allowed, and none without a sandbox.
Verification verify_store(const std::string& path, const StoreFilter& filter, const VerificationOrder& order);

}  // namespace labmouse
