// Sandbox for external mice: Linux namespaces, which need no privileges if the kernel allows it.
#pragma once

#include <string>

#include "labmouse/external/new_root.hpp"

namespace labmouse {

/// Moves the calling process, which must have only one thread, into new user, PID, network and IPC namespaces; its next
/// child is the first process there. False with errno if the system does not allow it. Allocates nothing and takes no
/// lock.
bool enter_namespaces();

/// Overwrites the command line of the calling process, so that it cannot be read in /proc; a forked process overwrites
/// its own copy. Allocates nothing and takes no lock.
void forget_command_line();

/// Drops all capabilities that the calling process has in the sandbox.
void drop_privileges();

/// Why this system has no sandboxes; empty if it has. Tries it once per program run.
const std::string& why_no_sandbox();

/// `copy` if this system allows overlays in a sandbox, else `read_only`.
FolderUse usual_folder_use();

}  // namespace labmouse
