#include "labmouse/lab/system/calls.hpp"

#include <fcntl.h>

#include <cerrno>
#include <cstdlib>

#ifdef _WIN32  // not tried
#include <io.h>
#include <process.h>
#include <sys/locking.h>
#else
#include <glob.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace labmouse {

#ifdef _WIN32

namespace {
constexpr int always = _O_BINARY | _O_NOINHERIT;
constexpr int readable_and_writable = 0600;
constexpr int may_write = 2;
}  // namespace

int open_to_read(const std::string& path) { return _open(path.c_str(), _O_RDONLY | always); }
int open_to_write(const std::string& path) { return _open(path.c_str(), _O_WRONLY | always); }
int open_new(const std::string& path, std::filesystem::perms) {
  return _open(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | always, readable_and_writable);
}
int open_lock(const std::string& path) {
  return _open(path.c_str(), _O_RDWR | _O_CREAT | always, readable_and_writable);
}
int close_descriptor(int descriptor) { return _close(descriptor); }

std::ptrdiff_t read_some(int descriptor, char* bytes, std::size_t most) {
  return _read(descriptor, bytes, static_cast<unsigned>(most));
}
std::ptrdiff_t write_some(int descriptor, const char* bytes, std::size_t count) {
  return _write(descriptor, bytes, static_cast<unsigned>(count));
}

int writable_error(int descriptor) { return _write(descriptor, "", 0) == 0 ? 0 : errno; }
int writable_error(const std::string& path) { return _access(path.c_str(), may_write) == 0 ? 0 : errno; }

int lock_file(int descriptor) { return _locking(descriptor, _LK_NBLCK, 1) == 0 ? 0 : EWOULDBLOCK; }
// Windows does not remove open files.
bool has_name(int) { return true; }

std::vector<std::string> paths_like(const std::string&) { return {}; }

int process_number() { return _getpid(); }

int become_program(std::vector<std::string>, std::vector<std::string>) { return ENOSYS; }

Undisturbed::Undisturbed() = default;
Undisturbed::~Undisturbed() = default;

#else

namespace {

/// Repeats a call that a signal interrupted.
template <class Call>
std::ptrdiff_t undisturbed(Call call) {
  std::ptrdiff_t result = 0;
  do {
    result = call();
  } while (result < 0 && errno == EINTR);
  return result;
}

}  // namespace

int open_to_read(const std::string& path) { return open(path.c_str(), O_RDONLY | O_CLOEXEC); }
int open_to_write(const std::string& path) { return open(path.c_str(), O_WRONLY | O_CLOEXEC); }
int open_new(const std::string& path, std::filesystem::perms permissions) {
  return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, static_cast<mode_t>(permissions));
}
int open_lock(const std::string& path) { return open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666); }
int close_descriptor(int descriptor) { return close(descriptor); }

std::ptrdiff_t read_some(int descriptor, char* bytes, std::size_t most) {
  return undisturbed([=] { return read(descriptor, bytes, most); });
}
std::ptrdiff_t write_some(int descriptor, const char* bytes, std::size_t count) {
  return undisturbed([=] { return write(descriptor, bytes, count); });
}

int writable_error(int descriptor) {
  const int flags = fcntl(descriptor, F_GETFL);
  if (flags < 0) return errno;
  return (flags & O_ACCMODE) == O_RDONLY ? EBADF : 0;
}
int writable_error(const std::string& path) {
  return faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0 ? 0 : errno;
}

int lock_file(int descriptor) { return flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? 0 : errno; }
bool has_name(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

std::vector<std::string> paths_like(const std::string& pattern) {
  glob_t matches{};
  std::vector<std::string> paths;
  if (glob(pattern.c_str(), 0, nullptr, &matches) == 0)
    paths.assign(matches.gl_pathv, matches.gl_pathv + matches.gl_pathc);
  globfree(&matches);
  return paths;
}

int process_number() { return getpid(); }

int become_program(std::vector<std::string> words, std::vector<std::string> environment) {
  std::vector<char*> line;
  for (std::string& word : words) line.push_back(word.data());
  line.push_back(nullptr);
  for (std::string& variable : environment)
    if (putenv(variable.data()) != 0) return errno;
  execvp(line.front(), line.data());
  return errno;
}

Undisturbed::Undisturbed() {
  sigset_t ends;
  sigemptyset(&ends);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ends, number);
  pthread_sigmask(SIG_BLOCK, &ends, &before_);
}
Undisturbed::~Undisturbed() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

#endif

}  // namespace labmouse
