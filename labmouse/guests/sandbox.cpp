#include "labmouse/guests/sandbox.hpp"

#include <fcntl.h>
#include <linux/capability.h>
#include <linux/mount.h>
#include <linux/securebits.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "labmouse/guests/short_text.hpp"

namespace labmouse {
namespace {

// All but why_no_sandbox runs between fork and exec: only functions that are safe in a signal handler.

bool write_whole(const char* path, const ShortText& text) {
  const int file = open(path, O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool good = write(file, text.c_str(), text.size()) == static_cast<ssize_t>(text.size());
  close(file);
  return good;
}

/// In a namespace of its own a process is nobody until it says who it was outside.
bool stay_the_same_user(uid_t user, gid_t group) {
  ShortText users, groups, deny;
  users << user << " " << user << " 1";
  groups << group << " " << group << " 1";
  deny << "deny";
  return write_whole("/proc/self/setgroups", deny) && write_whole("/proc/self/uid_map", users) &&
         write_whole("/proc/self/gid_map", groups);
}

bool change_mounts(const char* path, unsigned flags, std::uint64_t set, std::uint64_t clear) {
  mount_attr change{};
  change.attr_set = set;
  change.attr_clr = clear;
  return syscall(SYS_mount_setattr, AT_FDCWD, path, flags, &change, sizeof change) == 0;
}

/// An empty folder in memory over an existing one.
bool mount_empty(const char* path, std::uint64_t room) {
  ShortText options;
  options << "mode=1777,size=" << room;
  return mount("labmouse", path, "tmpfs", MS_NOSUID | MS_NODEV, options.c_str()) == 0;
}

/// Lets an entry of the old /tmp be seen in the new one, by a descriptor of it.
bool share_entry(int entry, const char* name) {
  ShortText from, to;
  from << "/proc/self/fd/" << static_cast<std::uint64_t>(entry);
  to << "/tmp/" << name;
  struct stat kind {};
  if (fstat(entry, &kind) != 0) return false;
  if (S_ISDIR(kind.st_mode)) {
    if (mkdir(to.c_str(), 0700) != 0) return false;
  } else {
    const int file = open(to.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
    if (file < 0) return false;
    close(file);
  }
  return mount(from.c_str(), to.c_str(), nullptr, MS_BIND | MS_REC, nullptr) == 0;
}

bool make_own_tmp(const Rooms& rooms) {
  constexpr std::size_t most = 16;
  std::array<int, most> entries{};
  std::size_t count = 0;
  for (; count < most && rooms.shared_entries != nullptr && rooms.shared_entries[count] != nullptr; ++count) {
    ShortText path;
    path << "/tmp/" << rooms.shared_entries[count];
    entries[count] = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (entries[count] < 0) return false;
  }
  if (!mount_empty("/tmp", rooms.room)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!share_entry(entries[i], rooms.shared_entries[i])) return false;
    close(entries[i]);
  }
  return true;
}

/// What it says to itself by way of the loopback stays with it; where that cannot be switched on, it has none.
void switch_loopback_on() {
  const int end = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (end < 0) return;
  ifreq request{};
  std::memcpy(request.ifr_name, "lo", sizeof "lo");
  request.ifr_flags = IFF_UP | IFF_RUNNING;
  ioctl(end, SIOCSIFFLAGS, &request);
  close(end);
}

/// Whether it could be entered, tried by a process that is given up for it; the reason where not.
std::string try_out() {
  const pid_t trial = fork();
  if (trial == 0) {
    Rooms rooms;
    rooms.room = 1U << 20U;
    const bool good = enter_sandbox(rooms);
    const int reason = errno;
    const pid_t first = good ? fork() : -1;
    if (first == 0) _exit(0);
    _exit(first > 0 ? 0 : (reason == 0 ? EPERM : reason));
  }
  int status = 0;
  if (trial < 0 || waitpid(trial, &status, 0) < 0) return std::strerror(errno);
  if (WIFEXITED(status)) return WEXITSTATUS(status) == 0 ? "" : std::strerror(WEXITSTATUS(status));
  return "the trial ended by a signal";
}

}  // namespace

bool enter_sandbox(const Rooms& rooms) {
  const uid_t user = geteuid();
  const gid_t group = getegid();
  const std::string_view folder = rooms.folder;
  if (unshare(CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWIPC) != 0) return false;
  if (!stay_the_same_user(user, group)) return false;
  if (mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return false;
  if (!change_mounts("/", AT_RECURSIVE, MOUNT_ATTR_RDONLY, 0)) return false;
  // Who lives in /tmp itself keeps it.
  if (folder != "/tmp" && !make_own_tmp(rooms)) return false;
  // Semaphores between processes are files there. Not every system has it.
  if (!mount_empty("/dev/shm", rooms.room) && errno != ENOENT) return false;
  if (folder != "/") {
    if (mount(rooms.folder, rooms.folder, nullptr, MS_BIND | MS_REC, nullptr) != 0) return false;
    // What is read-only outside stays so.
    if (!change_mounts(rooms.folder, 0, 0, MOUNT_ATTR_RDONLY) && errno != EPERM) return false;
  }
  switch_loopback_on();
  return true;
}

void show_own_processes() {
  // The keeper still looks at the others, so it is for those below only. Where parts of /proc are hidden it is not
  // allowed: there the others' names stay to be seen, and nothing else of them.
  if (unshare(CLONE_NEWNS) == 0)
    mount("labmouse", "/proc", "proc", MS_RDONLY | MS_NOSUID | MS_NODEV | MS_NOEXEC, nullptr);
}

void drop_privileges() {
  constexpr int last_known = 63;
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
  for (int number = 0; number <= last_known; ++number) prctl(PR_CAPBSET_DROP, number, 0, 0, 0);
  // The root of a namespace would get them back by starting any program.
  prctl(PR_SET_SECUREBITS, SECBIT_NOROOT | SECBIT_NOROOT_LOCKED, 0, 0, 0);
  __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, 2> none{};
  syscall(SYS_capset, &header, none.data());
}

const std::string& why_no_sandbox() {
  static const std::string reason = try_out();
  return reason;
}

}  // namespace labmouse
