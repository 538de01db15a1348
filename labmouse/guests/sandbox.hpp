// Rooms of its own for a guest: namespaces of Linux, which need no privileges where the kernel allows it.
#pragma once

#include <cstdint>
#include <string>

namespace labmouse {

/// What a guest in a sandbox may see and write, named before its process is made; the texts have to outlive it. All
/// else is read-only; processes outside are out of its reach, and so is every network.
struct Rooms {
  /// Its own folder, absolute, which it may write to; the root stays read-only.
  const char* folder = "/";
  /// What it needs of /tmp, in place of which it has an empty one: names of entries there, and a null at the end.
  const char* const* shared_entries = nullptr;
  /// Bytes that its /tmp holds.
  std::uint64_t room = 0;
};

/// Moves the calling process, which may have one thread only, into the sandbox; its next child is the first process
/// there. False with errno where the system does not allow it. Allocates nothing and takes no lock.
bool enter_sandbox(const Rooms& rooms);

/// Lets the first process there and those below it see themselves in /proc, and nobody outside where that is allowed.
void show_own_processes();

/// Gives up all that the calling process could still do within the sandbox that its user could not outside.
void drop_privileges();

/// Why there are no sandboxes on this system, or nothing where there are. Tries it out once a program.
const std::string& why_no_sandbox();

}  // namespace labmouse
