// System calls without an equivalent in the standard library. Only calls.cpp, live_source.cpp and page_server.cpp
// know the differences between systems. On failure, a call that returns a descriptor or a count returns -1 and sets
// errno; a call that returns an error number returns it, or 0 on success.
#pragma once

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace labmouse {

/// The descriptors that every program starts with.
inline constexpr int standard_input = 0, standard_output = 1, standard_error = 2;

/// Open a file; the descriptor is not inherited by started programs.
int open_to_read(const std::string& path);
int open_to_write(const std::string& path);
/// Creates a file that must not exist yet, with at most these permissions.
int open_new(const std::string& path, std::filesystem::perms permissions);
/// Opens a file for lock_file() and creates it if needed.
int open_lock(const std::string& path);
int close_descriptor(int descriptor);

/// Read or write up to that many bytes. Return the number of bytes done, which may be smaller; reading at the end of
/// the file returns 0.
std::ptrdiff_t read_some(int descriptor, char* bytes, std::size_t most);
std::ptrdiff_t write_some(int descriptor, const char* bytes, std::size_t count);

/// Check that a descriptor is open for writing, or that this program may write to an existing file. Return an error
/// number.
int writable_error(int descriptor);
int writable_error(const std::string& path);

/// Locks the whole file against other programs until it is closed. Returns an error number: EWOULDBLOCK where another
/// program has locked it.
int lock_file(int descriptor);
/// Whether the open file still has a name in a folder.
bool has_name(int descriptor);

/// The paths that match a shell pattern, sorted; none on Windows.
std::vector<std::string> paths_like(const std::string& pattern);

/// The process id.
int process_number();

/// Replaces this process by another program: the first of `words`, found as a shell does. `environment` has variables
/// NAME=VALUE, added to the inherited environment. Returns only on failure, with an error number. It always fails on
/// Windows.
int become_program(std::vector<std::string> words, std::vector<std::string> environment);

/// Blocks SIGINT, SIGTERM and SIGHUP in this thread while it lives.
class Undisturbed {
 public:
  Undisturbed();
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;
  ~Undisturbed();

 private:
#ifndef _WIN32
  sigset_t before_{};
#endif
};

}  // namespace labmouse
