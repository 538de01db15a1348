#include "labmouse/guests/keeper.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

namespace labmouse {
namespace {

// Everything here runs between fork and exec, or in a process that never leaves this file: only functions that are safe
// in a signal handler.

void report(int descriptor, int value) {
  while (write(descriptor, &value, sizeof value) < 0 && errno == EINTR) {
  }
}

[[noreturn]] void fail(const KeptEnds& ends) {
  report(ends.failure, errno);
  _exit(127);
}

void limit(int resource, rlim_t most, rlim_t beyond = 0) {
  rlimit now{};
  if (getrlimit(static_cast<__rlimit_resource>(resource), &now) != 0) return;
  const rlimit wanted = {std::min(most, now.rlim_max), std::min(most + beyond, now.rlim_max)};
  // A limit that cannot be set leaves the others and the wall clock.
  setrlimit(static_cast<__rlimit_resource>(resource), &wanted);
}

void limit_all(const GuestLimits& limits) {
  // A second between the two: at the first limit comes a signal that says which limit it was, at the second no other
  // than for everything else.
  limit(RLIMIT_CPU, static_cast<rlim_t>(limits.processor_seconds), 1);
  // Memory that is written to. Address space would be the wrong measure: some interpreters reserve gigabytes unused.
  limit(RLIMIT_DATA, limits.memory);
  limit(RLIMIT_CORE, 0);
}

/// Signals as a program expects them at its start.
void reset_signals() {
  struct sigaction plain {};
  plain.sa_handler = SIG_DFL;
  for (int number = 1; number < NSIG; ++number) sigaction(number, &plain, nullptr);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void become_guest(const char* path, char* const* words, char* const* environment, const char* directory,
                               const GuestLimits& limits, const KeptEnds& ends) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpgid(0, 0);
  if (dup2(ends.input, STDIN_FILENO) < 0 || dup2(ends.output, STDOUT_FILENO) < 0 ||
      dup2(ends.errors, STDERR_FILENO) < 0)
    fail(ends);
  if (*directory != '\0' && chdir(directory) != 0) fail(ends);
  reset_signals();
  limit_all(limits);
  execve(path, words, environment);
  fail(ends);
}

/// Moves a descriptor to 3 or above, where no standard stream will be put over it, and to be closed by exec.
int moved_up(int descriptor) { return descriptor > STDERR_FILENO ? descriptor : fcntl(descriptor, F_DUPFD_CLOEXEC, 3); }

void close_all_but(const std::array<int, 6>& kept) {
  std::array<int, 6> sorted = kept;
  std::sort(sorted.begin(), sorted.end());
  unsigned first = STDERR_FILENO + 1;
  for (const int descriptor : sorted) {
    const auto number = static_cast<unsigned>(descriptor);
    if (number > first) syscall(SYS_close_range, first, number - 1, 0U);
    first = number + 1;
  }
  syscall(SYS_close_range, first, ~0U, 0U);
}

/// Ends each child of this process; those of a child that ends come to be ours, since nobody else takes them. False
/// where the system does not tell who they are, or where one of them is of another user and may not be ended.
bool kill_children() {
  std::array<char, 4096> text{};
  const int list = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
  if (list < 0) return false;
  const ssize_t size = read(list, text.data(), text.size());
  close(list);
  pid_t number = 0;
  bool all = true;
  for (ssize_t i = 0; i < size; ++i) {
    const char letter = text[static_cast<std::size_t>(i)];
    if (letter >= '0' && letter <= '9') {
      number = number * 10 + (letter - '0');
      continue;
    }
    if (number > 0 && kill(number, SIGKILL) != 0 && errno != ESRCH) all = false;
    number = 0;
  }
  return all;
}

/// Ends all descendants and buries them.
void end_all() {
  for (;;) {
    // To wait for one that was not killed could take for ever.
    if (waitpid(-1, nullptr, kill_children() ? 0 : WNOHANG) <= 0) return;
  }
}

void note_child_ended(int) {}

}  // namespace

void keep_guest(const char* path, char* const* words, char* const* environment, const char* directory,
                const GuestLimits& limits, const KeptEnds& ends) {
  const KeptEnds kept = {moved_up(ends.input),   moved_up(ends.output), moved_up(ends.errors),
                         moved_up(ends.failure), moved_up(ends.status), moved_up(ends.leash)};
  for (const int end : {kept.input, kept.output, kept.errors, kept.failure, kept.status, kept.leash})
    if (end < 0) fail(ends);
  // A session of its own: Ctrl-C and a closed terminal are not for guests. Of other guests it must hold nothing.
  setsid();
  close_all_but({kept.input, kept.output, kept.errors, kept.failure, kept.status, kept.leash});
  prctl(PR_SET_CHILD_SUBREAPER, 1);

  struct sigaction noted {};
  noted.sa_handler = note_child_ended;
  sigaction(SIGCHLD, &noted, nullptr);
  sigset_t child_ended, before;
  sigemptyset(&child_ended);
  sigaddset(&child_ended, SIGCHLD);
  sigprocmask(SIG_BLOCK, &child_ended, &before);
  sigdelset(&before, SIGCHLD);

  const pid_t guest = fork();
  if (guest < 0) fail(kept);
  if (guest == 0) become_guest(path, words, environment, directory, limits, kept);
  report(kept.status, guest);
  setpgid(guest, guest);  // here too: whichever of the two comes first
  for (const int descriptor : {kept.input, kept.output, kept.errors, kept.failure}) close(descriptor);

  bool runs = true;
  for (;;) {
    pollfd leash = {kept.leash, POLLIN, 0};
    if (ppoll(&leash, 1, nullptr, &before) > 0) break;
    int status = 0;
    for (pid_t ended; (ended = waitpid(-1, &status, WNOHANG)) > 0;) {
      if (ended != guest) continue;
      report(kept.status, status);
      runs = false;
    }
  }
  // The whole group in one stroke, lest it forks faster than we look. Once the guest was buried its number may be
  // another's.
  if (runs) kill(-guest, SIGKILL);
  end_all();
  _exit(0);
}

}  // namespace labmouse
