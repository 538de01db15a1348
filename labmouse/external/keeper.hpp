// The keeper: a process between labmouse and an external mouse that ends everything the mouse started.
#pragma once

#include <sys/types.h>

#include "labmouse/external/limits.hpp"
#include "labmouse/external/new_root.hpp"

namespace labmouse {

/// Pipe ends (descriptors) of an external mouse and its keeper.
struct KeptEnds {
  int input = -1, output = -1, errors = -1;  ///< the external mouse's standard streams
  int failure = -1;                          ///< gets the errno of a failed start; a successful start closes it
  int status = -1;                           ///< gets the keeper's messages (KeeperWord)
  int leash = -1;                            ///< when its other end closes, the keeper ends all processes of the mouse
};

/// A message of the keeper, sent in one write: first `first`, later one of the others.
struct KeeperWord {
  enum class Kind : int {
    first,     ///< `value` is the created process: the external mouse, or in a sandbox its parent
    ended,     ///< the external mouse ended; `value` is its wait status
    exceeded,  ///< the mouse and its descendants exceeded the TreeLimit `value`, and were ended
  };
  Kind kind = Kind::first;
  int value = 0;
};

/// What to start. Texts and lists end with a zero, and must outlive the start of the keeper.
struct KeptExternal {
  const char* path;
  char* const* words;
  char* const* environment;
  const char* directory;  ///< empty: the current one
  const ExternalLimits& limits;
  const Rooms* rooms;  ///< null: no sandbox
};

/// Starts the external mouse, and runs until the leash is closed; never returns. Call it in a new process. That process
/// may be forked from a program with threads, so it allocates nothing and takes no lock.
[[noreturn]] void keep_external(const KeptExternal& external, const KeptEnds& ends);

}  // namespace labmouse
