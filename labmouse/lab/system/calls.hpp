// What the standard library has no words for, and is asked of the system by its own calls. calls.cpp alone knows that
// systems differ. Where a call fails it gives -1 and leaves its reason in errno, or gives that number, and 0 where it
// did not fail.
#pragma once

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace labmouse {

/// The descriptors that every program begins with.
inline constexpr int standard_input = 0, standard_output = 1, standard_error = 2;

/// Descriptors that programs which are started do not get.
int open_to_read(const std::string& path);
int open_to_write(const std::string& path);
/// A file that was not there, with these permissions at most.
int open_new(const std::string& path, std::filesystem::perms permissions);
/// A file to be locked, which is made where it is not there.
int open_lock(const std::string& path);
int close_descriptor(int descriptor);

/// How many bytes were read or written, which may be fewer than asked for; at the end 0.
std::ptrdiff_t read_some(int descriptor, char* bytes, std::size_t most);
std::ptrdiff_t write_some(int descriptor, const char* bytes, std::size_t count);

/// Whether a descriptor is open for writing, and whether this program may write to a file that is there: error numbers.
int writable_error(int descriptor);
int writable_error(const std::string& path);

/// Locks the whole file against other programs until it is closed: an error number, EWOULDBLOCK where another has it.
int lock_file(int descriptor);
/// Whether the open file still stands in a folder.
bool has_name(int descriptor);

/// The paths that match a pattern as of a shell, sorted; none on Windows.
std::vector<std::string> paths_like(const std::string& pattern);

/// Different from that of every other program that runs.
int process_number();

/// This process becomes another program, the first of the words, which is looked for as by a shell; with one more
/// variable in its environment. Returns an error number where that fails, as always on Windows.
int become_program(const std::vector<std::string>& words, const std::string& variable, const std::string& value);

/// While one of these lives, no signal ends this thread.
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
