// Builds the file system of a sandbox: a new root with only what an external mouse may see.
#pragma once

#include <cstdint>

namespace labmouse {

/// How the mouse's folder appears in its sandbox.
enum class FolderUse {
  copy,       ///< an overlay whose changes are discarded; read-only if other file systems are mounted inside
  read_only,  ///< for systems without overlays; only /tmp is writable
  keep,       ///< the real folder, writable
};

/// What a mouse in a sandbox may see and write, computed before its process is created. Texts and lists must outlive
/// it; lists end with a null. All paths are absolute.
struct Rooms {
  struct Link {
    const char* path = nullptr;
    const char* target = nullptr;
  };
  const char* folder = "";               ///< its own; empty: none
  const char* directory = "/";           ///< its working directory
  const char* const* visible = nullptr;  ///< what it may read, parents first
  const Link* links = nullptr;           ///< links on the way to visible paths
  const char* const* hidden = nullptr;   ///< parts of these that are hidden
  /// Bytes that it may write to its folder, /tmp and /dev/shm together.
  std::uint64_t room = 0;
  FolderUse use = FolderUse::copy;
};

/// Gives the calling process, the first of a new PID namespace, a root with only that. False with errno if the system
/// does not allow it. Allocates nothing and takes no lock.
bool enter_new_root(const Rooms& rooms);

}  // namespace labmouse
