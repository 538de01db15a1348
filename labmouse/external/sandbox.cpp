#include "labmouse/external/sandbox.hpp"

#include <fcntl.h>
#include <linux/capability.h>
#include <linux/securebits.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "labmouse/external/short_text.hpp"
#include "labmouse/functions/parse_number.hpp"

namespace labmouse {
namespace {

// Except for try_out() and the last two functions, all of this runs between fork and exec, so it uses only
// async-signal-safe functions.

bool write_whole(const char* path, const ShortText& text) {
  const int file = open(path, O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool good = write(file, text.c_str(), text.size()) == static_cast<ssize_t>(text.size());
  close(file);
  return good;
}

/// In a new user namespace a process is `nobody` until it maps its user and group ids.
bool stay_the_same_user(uid_t user, gid_t group) {
  ShortText users, groups, deny;
  users << user << " " << user << " 1";
  groups << group << " " << group << " 1";
  deny << "deny";
  return write_whole("/proc/self/setgroups", deny) && write_whole("/proc/self/uid_map", users) &&
         write_whole("/proc/self/gid_map", groups);
}

/// Switches on the loopback interface of the new network namespace; without success there is none.
void switch_loopback_on() {
  const int end = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (end < 0) return;
  ifreq request{};
  std::memcpy(request.ifr_name, "lo", sizeof "lo");
  request.ifr_flags = IFF_UP | IFF_RUNNING;
  ioctl(end, SIOCSIFFLAGS, &request);
  close(end);
}

/// Tries a sandbox in a child process. Returns 0, or the errno of the failure.
int try_out(FolderUse use) {
  const pid_t trial = fork();
  if (trial == 0) {
    Rooms rooms;
    rooms.folder = "/usr";
    rooms.room = 1U << 20U;
    rooms.use = use;
    const pid_t first = enter_namespaces() ? fork() : -1;
    if (first < 0) _exit(errno);
    if (first == 0) _exit(enter_new_root(rooms) ? 0 : errno);
    int status = 0;
    if (waitpid(first, &status, 0) < 0) _exit(errno);
    _exit(WIFEXITED(status) ? WEXITSTATUS(status) : EINTR);
  }
  int status = 0;
  if (trial < 0 || waitpid(trial, &status, 0) < 0) return errno;
  return WIFEXITED(status) ? WEXITSTATUS(status) : EINTR;
}

/// The number in /proc/self/stat that follows so many other fields; 0 if it cannot be read.
std::uintptr_t number_of_stat(std::string_view text, int before) {
  // The name, in brackets, may hold anything.
  text.remove_prefix(std::min(text.rfind(')') + 2, text.size()));
  constexpr int behind_name = 2;
  for (int i = behind_name; i < before; ++i) text.remove_prefix(std::min(text.find(' '), text.size() - 1) + 1);
  return take_whole<std::uintptr_t>(text).value_or(0);
}

}  // namespace

bool enter_namespaces() {
  const uid_t user = geteuid();
  const gid_t group = getegid();
  if (unshare(CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWIPC) != 0) return false;
  if (!stay_the_same_user(user, group)) return false;
  switch_loopback_on();
  return true;
}

void forget_command_line() {
  constexpr int arg_start = 47, arg_end = 48;
  std::array<char, 2048> text{};
  const int file = open("/proc/self/stat", O_RDONLY | O_CLOEXEC);
  const ssize_t size = file < 0 ? 0 : read(file, text.data(), text.size());
  if (file >= 0) close(file);
  const std::string_view line(text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  if (line.empty()) return;
  const std::uintptr_t begin = number_of_stat(line, arg_start), end = number_of_stat(line, arg_end);
  // The kernel gives the address as a number. NOLINTNEXTLINE(performance-no-int-to-ptr)
  if (begin != 0 && end > begin) std::memset(reinterpret_cast<void*>(begin), 0, end - begin);
}

void drop_privileges() {
  constexpr int last_known = 63;
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
  for (int number = 0; number <= last_known; ++number) prctl(PR_CAPBSET_DROP, number, 0, 0, 0);
  // Root of a namespace would get them back by exec.
  prctl(PR_SET_SECUREBITS, SECBIT_NOROOT | SECBIT_NOROOT_LOCKED, 0, 0, 0);
  __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, 2> none{};
  syscall(SYS_capset, &header, none.data());
}

const std::string& why_no_sandbox() {
  static const std::string reason = [] {
    const int error = usual_folder_use() == FolderUse::copy ? 0 : try_out(FolderUse::read_only);
    return error == 0 ? std::string() : std::string(std::strerror(error));
  }();
  return reason;
}

FolderUse usual_folder_use() {
  static const FolderUse use = try_out(FolderUse::copy) == 0 ? FolderUse::copy : FolderUse::read_only;
  return use;
}

}  // namespace labmouse
