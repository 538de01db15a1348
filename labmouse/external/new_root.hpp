// The file system of an external mouse: a root of its own, put together from what it may see.
#pragma once

#include <cstdint>

namespace labmouse {

/// How the folder of a mouse is shown to it while it runs.
enum class FolderUse {
  copy,       ///< what it writes there is gone with it: an overlay; read-only where others are mounted inside
  read_only,  ///< it writes only to /tmp: where the system has no overlays
  keep,       ///< it writes to the folder itself
};

/// What a mouse in a sandbox may see and write, found out before its process is made. Texts and lists outlive it; lists
/// end with a null. All paths are absolute.
struct Rooms {
  struct Link {
    const char* path = nullptr;
    const char* target = nullptr;
  };
  const char* folder = "";               ///< its own; empty: none
  const char* directory = "/";           ///< where it starts
  const char* const* visible = nullptr;  ///< what it may read, parents first
  const Link* links = nullptr;           ///< on the way to that
  const char* const* hidden = nullptr;   ///< what of all that is covered
  /// Bytes that it may write to its folder, /tmp and /dev/shm together.
  std::uint64_t room = 0;
  FolderUse use = FolderUse::copy;
};

/// Gives the calling process, the first of a new namespace of processes, a root that has nothing else than that. False
/// with errno where the system does not allow it. Allocates nothing and takes no lock.
bool enter_new_root(const Rooms& rooms);

}  // namespace labmouse
