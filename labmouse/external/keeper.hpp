// The process between us and an external mouse.
#pragma once

#include <sys/types.h>

#include "labmouse/external/limits.hpp"
#include "labmouse/external/new_root.hpp"

namespace labmouse {

/// The ends that an external mouse and its keeper hold.
struct KeptEnds {
  int input = -1, output = -1, errors = -1;  ///< the external mouse's standard streams
  int failure = -1;                          ///< takes the errno of a failed start, and is closed by one that succeeds
  int status = -1;                           ///< takes what the keeper tells
  int leash = -1;                            ///< at its end everything that the external mouse left is ended
};

/// What a keeper tells, whole in one write: first `first`, later one of the others.
struct KeeperWord {
  enum class Kind : int {
    first,     ///< the process that it made: the external mouse, or in a sandbox the external mouse's parent
    ended,     ///< the external mouse ended, with this wait status
    exceeded,  ///< the external mouse and what it started passed this TreeLimit, and were ended
  };
  Kind kind = Kind::first;
  int value = 0;
};

/// What to start. The texts and lists end with a zero and outlive the keeper's start.
struct KeptExternal {
  const char* path;
  char* const* words;
  char* const* environment;
  const char* directory;  ///< empty: here
  const ExternalLimits& limits;
  const Rooms* rooms;  ///< null: no sandbox
};

/// Starts the external mouse and stays until the leash is let go; never returns. To be called in a new process that may
/// have been forked beside other threads: it allocates nothing and takes no lock.
[[noreturn]] void keep_external(const KeptExternal& external, const KeptEnds& ends);

}  // namespace labmouse
