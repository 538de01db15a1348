// Contests of a store held again, to see whether they come to what the store says.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/lab/store/stored_races.hpp"

namespace labmouse {

struct VerificationOrder {
  double share = 0.05;     ///< of the contests, 0 to 1, picked at random
  std::uint64_t seed = 1;  ///< of that choice
  int jobs = 0;
  GuestOptions guests = {};
  const std::atomic<bool>* stop = nullptr;  ///< once true no other contest begins
};

struct Verification {
  std::int64_t held = 0;                 ///< contests that were held again
  std::int64_t equal = 0;                ///< those that came to the same, but for timings
  std::vector<std::string> differences;  ///< the others, a line each
  std::int64_t impossible = 0;           ///< contests that were picked and whose mouse is not here any more
  std::vector<std::string> remarks;
  std::string error;  ///< why nothing could be verified, as a line for the user
};

/// Checks the file as a whole, and holds a share of its contests again. A mouse is here where its SPEC leads to the
/// same one: the same build, the same files.
Verification verify_store(const std::string& path, const StoreFilter& filter, const VerificationOrder& order);

}  // namespace labmouse
