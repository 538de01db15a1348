// Rooms of its own for an external mouse: namespaces of Linux, which need no privileges where the kernel allows it.
#pragma once

#include <string>

#include "labmouse/external/new_root.hpp"

namespace labmouse {

/// Moves the calling process, which may have one thread only, into namespaces of its own for users, processes, networks
/// and messages; its next child is the first process there. False with errno where the system does not allow it.
/// Allocates nothing and takes no lock.
bool enter_namespaces();

/// Overwrites the words of the command line that the calling process was started with, so that they cannot be read in
/// /proc; a forked process overwrites its own copy. Allocates nothing and takes no lock.
void forget_command_line();

/// Gives up all that the calling process could still do within the sandbox that its user could not outside.
void drop_privileges();

/// Why there are no sandboxes on this system, or nothing where there are. Tries it out once a program.
const std::string& why_no_sandbox();

/// Whether the folder of a mouse can be a copy in a sandbox here, or is read-only for want of overlays.
FolderUse usual_folder_use();

}  // namespace labmouse
