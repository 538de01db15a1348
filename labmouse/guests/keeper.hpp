// The process between us and a guest.
#pragma once

#include <sys/types.h>

#include "labmouse/guests/limits.hpp"

namespace labmouse {

/// The ends that a guest and its keeper hold.
struct KeptEnds {
  int input = -1, output = -1, errors = -1;  ///< the guest's standard streams
  int failure = -1;                          ///< takes the errno of a failed start, and is closed by one that succeeds
  int status = -1;                           ///< takes the guest's number, and its wait status when it ends
  int leash = -1;                            ///< at its end everything that the guest left is ended
};

/// Starts the guest and stays until the leash is let go; never returns. To be called in a new process that may have
/// been forked beside other threads: it allocates nothing and takes no lock. `words` and `environment` end with a null.
[[noreturn]] void keep_guest(const char* path, char* const* words, char* const* environment, const char* directory,
                             const GuestLimits& limits, const KeptEnds& ends);

}  // namespace labmouse
