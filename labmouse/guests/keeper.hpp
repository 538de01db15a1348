// The process between us and a guest.
#pragma once

#include <sys/types.h>

#include "labmouse/guests/limits.hpp"
#include "labmouse/guests/new_root.hpp"

namespace labmouse {

/// The ends that a guest and its keeper hold.
struct KeptEnds {
  int input = -1, output = -1, errors = -1;  ///< the guest's standard streams
  int failure = -1;                          ///< takes the errno of a failed start, and is closed by one that succeeds
  int status = -1;                           ///< takes what the keeper tells
  int leash = -1;                            ///< at its end everything that the guest left is ended
};

/// What a keeper tells, whole in one write: first `first`, later one of the others.
struct KeeperWord {
  enum class Kind : int {
    first,     ///< the process that it made: the guest, or in a sandbox the guest's parent
    ended,     ///< the guest ended, with this wait status
    exceeded,  ///< the guest and what it started passed this TreeLimit, and were ended
  };
  Kind kind = Kind::first;
  int value = 0;
};

/// What to start. The texts and lists end with a zero and outlive the keeper's start.
struct KeptGuest {
  const char* path;
  char* const* words;
  char* const* environment;
  const char* directory;  ///< empty: here
  const GuestLimits& limits;
  const Rooms* rooms;  ///< null: no sandbox
};

/// Starts the guest and stays until the leash is let go; never returns. To be called in a new process that may have
/// been forked beside other threads: it allocates nothing and takes no lock.
[[noreturn]] void keep_guest(const KeptGuest& guest, const KeptEnds& ends);

}  // namespace labmouse
