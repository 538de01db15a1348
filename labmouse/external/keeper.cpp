#include "labmouse/external/keeper.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

#include "labmouse/external/sandbox.hpp"
#include "labmouse/external/survey.hpp"
#include "labmouse/functions/parse_number.hpp"

namespace labmouse {
namespace {

// All of this runs between fork and exec, or in a process that never leaves this file, so it uses only
// async-signal-safe functions.

template <class Value>
void report(int descriptor, const Value& value) {
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
  // If a limit cannot be set, the other limits and the wall clock remain.
  setrlimit(static_cast<__rlimit_resource>(resource), &wanted);
}

/// Limit on all tasks (processes and threads) of the user, with room for normal mice. It only slows down a fork bomb
/// until the watch detects it. It has no effect for root.
rlim_t most_tasks() {
  constexpr rlim_t room = 1024;
  std::array<char, 64> text{};
  const int file = open("/proc/loadavg", O_RDONLY | O_CLOEXEC);
  const ssize_t size = file < 0 ? 0 : read(file, text.data(), text.size());
  if (file >= 0) close(file);
  // "0.20 0.18 0.12 1/80 11206": the number after the slash is that of all tasks of the system.
  std::string_view rest(text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  rest.remove_prefix(std::min(rest.find('/'), rest.size() - 1) + 1);
  const auto tasks = take_whole<rlim_t>(rest);
  return tasks ? *tasks + room : RLIM_INFINITY;
}

void limit_all(const ExternalLimits& limits) {
  // One second between both limits: the first sends SIGXCPU, which names the limit; the second sends SIGKILL, which
  // does not.
  limit(RLIMIT_CPU, static_cast<rlim_t>(limits.processor_seconds), 1);
  // Limits writable memory, not address space, because some interpreters reserve gigabytes without use. Twice the
  // allowed size, so that the watch detects the excess first and can report it.
  limit(RLIMIT_DATA, 2 * limits.memory);
  limit(RLIMIT_FSIZE, limits.written);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_NPROC, most_tasks());
}

/// Restores default signal handlers and an empty signal mask, as a program expects.
void reset_signals() {
  struct sigaction plain {};
  plain.sa_handler = SIG_DFL;
  for (int number = 1; number < NSIG; ++number) sigaction(number, &plain, nullptr);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void become_external(const KeptExternal& external, const KeptEnds& ends) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpgid(0, 0);
  if (dup2(ends.input, STDIN_FILENO) < 0 || dup2(ends.output, STDOUT_FILENO) < 0 ||
      dup2(ends.errors, STDERR_FILENO) < 0)
    fail(ends);
  const char* directory = external.rooms != nullptr ? external.rooms->directory : external.directory;
  if (*directory != '\0' && chdir(directory) != 0) fail(ends);
  reset_signals();
  limit_all(external.limits);
  if (external.rooms != nullptr) drop_privileges();
  execve(external.path, external.words, external.environment);
  fail(ends);
}

/// Moves a descriptor to 3 or above, so that standard streams do not overwrite it; exec closes it.
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

/// Kills and reaps all descendants.
void end_all() {
  for (;;) {
    // Waiting for a process that was not killed could block for ever.
    if (waitpid(-1, nullptr, kill_descendants(getpid()) ? 0 : WNOHANG) <= 0) return;
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
  }
}

/// Wait status of an ended process; SIGXCPU instead of SIGKILL if it ignored the first signal of the processor time
/// limit.
int end_of(int status, const rusage& used, const ExternalLimits& limits) {
  const bool all_used = used.ru_utime.tv_sec + used.ru_stime.tv_sec >= limits.processor_seconds;
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL && all_used ? SIGXCPU : status;
}

void note_child_ended(int) {}

/// Takes a higher priority than external mice, if allowed: among thousands of processes, the keeper would get no time
/// to end them.
void come_first() {
  sched_param priority{};
  priority.sched_priority = 1;
  sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &priority);
}

/// Blocks SIGCHLD except during ppoll, so that no signal is lost between a check and the wait. Returns the signal mask
/// for ppoll.
sigset_t hold_back_ends_of_children() {
  struct sigaction noted {};
  noted.sa_handler = note_child_ended;
  sigaction(SIGCHLD, &noted, nullptr);
  sigset_t child_ended, before;
  sigemptyset(&child_ended);
  sigaddset(&child_ended, SIGCHLD);
  sigprocmask(SIG_BLOCK, &child_ended, &before);
  sigdelset(&before, SIGCHLD);
  return before;
}

/// The first process (init) of a sandbox: it starts the external mouse, and adopts orphans. When it ends, all other
/// processes of the sandbox end.
[[noreturn]] void parent_program(const KeptExternal& external, const KeptEnds& ends) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  forget_command_line();
  if (!enter_new_root(*external.rooms)) fail(ends);
  const pid_t child = fork();
  if (child < 0) fail(ends);
  if (child == 0) become_external(external, ends);
  for (const int descriptor : {ends.input, ends.output, ends.errors, ends.failure}) close(descriptor);
  for (int status = 0;;) {
    rusage used{};
    const pid_t ended = wait4(-1, &status, 0, &used);
    if (ended == child) report(ends.status, KeeperWord{KeeperWord::Kind::ended, end_of(status, used, external.limits)});
    if (ended < 0) pause();
  }
}

/// Ends the external mouse and all its descendants.
void end_external(const KeptExternal& external, pid_t child, bool runs) {
  // Kills the whole group at once, because it may fork faster than its processes can be listed. After the mouse was
  // reaped, its process id may be reused.
  if (runs) kill(external.rooms != nullptr ? child : -child, SIGKILL);
  end_all();
}

}  // namespace

void keep_external(const KeptExternal& external, const KeptEnds& ends) {
  const KeptEnds kept = {moved_up(ends.input),   moved_up(ends.output), moved_up(ends.errors),
                         moved_up(ends.failure), moved_up(ends.status), moved_up(ends.leash)};
  for (const int end : {kept.input, kept.output, kept.errors, kept.failure, kept.status, kept.leash})
    if (end < 0) fail(ends);
  // A new session, so that Ctrl-C and a closed terminal do not reach external mice. It must not hold descriptors of
  // other external mice.
  setsid();
  close_all_but({kept.input, kept.output, kept.errors, kept.failure, kept.status, kept.leash});
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  come_first();
  const sigset_t while_waiting = hold_back_ends_of_children();
  if (external.rooms != nullptr && !enter_namespaces()) fail(kept);

  const pid_t child = fork();
  if (child < 0) fail(kept);
  if (child == 0 && external.rooms != nullptr) parent_program(external, kept);
  if (child == 0) become_external(external, kept);
  report(kept.status, KeeperWord{KeeperWord::Kind::first, child});
  if (external.rooms == nullptr) setpgid(child, child);  // in parent and child, because either may run first
  for (const int descriptor : {kept.input, kept.output, kept.errors, kept.failure}) close(descriptor);

  TreeWatch watch(external.rooms != nullptr ? child : getpid(), external.limits);
  bool runs = true, watched = true;
  for (;;) {
    pollfd leash = {kept.leash, POLLIN, 0};
    const timespec pause = {0, watch.pause() * 1'000'000L};
    const int happened = ppoll(&leash, 1, watched ? &pause : nullptr, &while_waiting);
    if (happened > 0) break;
    int status = 0;
    rusage used{};
    for (pid_t ended; (ended = wait4(-1, &status, WNOHANG, &used)) > 0;) {
      if (ended != child) continue;
      report(kept.status, KeeperWord{KeeperWord::Kind::ended, end_of(status, used, external.limits)});
      runs = false;
    }
    if (happened < 0) continue;
    const TreeLimit limit = watch.look();
    if (limit == TreeLimit::none) continue;
    report(kept.status, KeeperWord{KeeperWord::Kind::exceeded, static_cast<int>(limit)});
    end_external(external, child, runs);
    runs = watched = false;
  }
  end_external(external, child, runs);
  _exit(0);
}

}  // namespace labmouse
