#include "labmouse/external/new_root.hpp"

#include <fcntl.h>
#include <linux/mount.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

#include "labmouse/external/short_text.hpp"
#include "labmouse/external/surroundings.hpp"

namespace labmouse {
namespace {

// All of this runs between fork and exec, so it uses only async-signal-safe functions.

// While the new root is built, the current root is a temporary tmpfs:
constexpr std::string_view old_root = "/old", new_root = "/new";  // the old root, and the mount of the new one
constexpr const char *tmp = "/tmp", *shm = "/shm", *upper = "/upper", *work = "/work";  // writable folders
constexpr const char *lower_folder = "/lower", *no_folder = "/none", *no_file = "/empty";

struct Path {
  Path(std::string_view root, std::string_view path) { text << root << path; }
  const char* c_str() const { return text.c_str(); }
  ShortText text;
};

bool mount_tmpfs(const char* path, std::uint64_t size) {
  ShortText options;
  options << "mode=755";
  if (size > 0) options << ",size=" << size;
  return mount("labmouse", path, "tmpfs", MS_NOSUID | MS_NODEV, options.c_str()) == 0;
}

bool change_mounts(const char* path, unsigned flags, std::uint64_t set, std::uint64_t clear) {
  mount_attr change{};
  change.attr_set = set;
  change.attr_clr = clear;
  return syscall(SYS_mount_setattr, AT_FDCWD, path, flags, &change, sizeof change) == 0;
}

bool bind(const char* from, const char* to) { return mount(from, to, nullptr, MS_BIND | MS_REC, nullptr) == 0; }

bool make_folder(const char* path) { return mkdir(path, 0755) == 0 || errno == EEXIST; }

bool make_file(const char* path) {
  const int file = open(path, O_CREAT | O_WRONLY | O_CLOEXEC, 0644);
  if (file >= 0) close(file);
  return file >= 0 || errno == EEXIST || errno == EROFS;
}

/// Creates all folders above a path of the new root.
bool make_parents(std::string_view path) {
  for (std::size_t end = path.find('/', 1); end != std::string_view::npos; end = path.find('/', end + 1))
    if (!make_folder(Path(new_root, path.substr(0, end)).c_str())) return false;
  return true;
}

bool make_folders(std::string_view path) { return make_parents(path) && make_folder(Path(new_root, path).c_str()); }

/// Makes a file or folder of the old root visible in the new one. A missing one is skipped.
bool show(std::string_view path) {
  const Path from(old_root, path), to(new_root, path);
  struct stat kind {};
  if (lstat(from.c_str(), &kind) != 0) return true;
  if (!make_parents(path) || !(S_ISDIR(kind.st_mode) ? make_folder(to.c_str()) : make_file(to.c_str()))) return false;
  return bind(from.c_str(), to.c_str());
}

bool show_all(const Rooms& rooms) {
  for (const Rooms::Link* link = rooms.links; link != nullptr && link->path != nullptr; ++link)
    if (!make_parents(link->path) ||
        (symlink(link->target, Path(new_root, link->path).c_str()) != 0 && errno != EEXIST))
      return false;
  for (const char* const* path = rooms.visible; path != nullptr && *path != nullptr; ++path)
    if (!show(*path)) return false;
  return true;
}

/// The devices that every program expects; no disk and no terminal.
bool make_devices() {
  for (const char* name : {"/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom"})
    if (!show(name)) return false;
  constexpr std::string_view names[][2] = {
      {"/dev/fd", "/proc/self/fd"}, {"/dev/stdin", "fd/0"}, {"/dev/stdout", "fd/1"}, {"/dev/stderr", "fd/2"}};
  for (const auto& [name, target] : names)
    if (symlink(target.data(), Path(new_root, name).c_str()) != 0) return false;
  return true;
}

/// Mounts a /proc with only the mouse's own processes. If parts of the old /proc are hidden, the system does not allow
/// a new one, and the mouse has none.
bool make_proc() {
  if (!make_folders("/proc")) return false;
  const Path proc(new_root, "/proc");
  constexpr unsigned long flags = MS_NOSUID | MS_NODEV | MS_NOEXEC;
  // Hides the first process, too, which belongs to labmouse. Older systems hide it from fewer users, or not at all.
  for (const char* options : {"hidepid=ptraceable", "hidepid=2", ""})
    if (mount("labmouse", proc.c_str(), "proc", flags, options) == 0) break;
  // Shows the number of processors.
  constexpr std::string_view processors = "/sys/devices/system/cpu";
  return show(processors);
}

/// Hides a file or folder: deletes it in a copy, or covers it by an empty one.
bool hide(std::string_view path, bool is_copy) {
  const Path place(new_root, path);
  struct stat kind {};
  if (lstat(place.c_str(), &kind) != 0) return true;
  if (S_ISDIR(kind.st_mode)) return bind(no_folder, place.c_str());
  if (is_copy && unlink(place.c_str()) == 0) return true;
  // The target of a link is hidden by its own path.
  return S_ISLNK(kind.st_mode) || bind(no_file, place.c_str());
}

bool hide_all(const Rooms& rooms, bool in_folder) {
  for (const char* const* path = rooms.hidden; path != nullptr && *path != nullptr; ++path)
    if (lies_in(*path, rooms.folder) == in_folder && !hide(*path, in_folder && rooms.use == FolderUse::copy))
      return false;
  return true;
}

/// The folder itself, without a copy.
bool bind_own_folder(const char* from, const char* to, bool is_read_only) {
  return bind(from, to) && (!is_read_only || change_mounts(to, AT_RECURSIVE, MOUNT_ATTR_RDONLY, 0));
}

bool make_own_folder(const Rooms& rooms) {
  const Path from(old_root, rooms.folder), to(new_root, rooms.folder);
  if (rooms.use != FolderUse::copy) return bind_own_folder(from.c_str(), to.c_str(), rooms.use == FolderUse::read_only);
  // Binds it to a path without colons and commas, which overlay options cannot contain.
  if (!bind(from.c_str(), lower_folder)) return false;
  const auto mount_overlay = [&](const char* options) {
    return mount("labmouse", to.c_str(), "overlay", 0, options) == 0;
  };
  if (mount_overlay("lowerdir=/lower,upperdir=/upper,workdir=/work,userxattr") ||
      mount_overlay("lowerdir=/lower,upperdir=/upper,workdir=/work"))
    return true;
  // An overlay is impossible if other file systems are mounted in the folder.
  return errno == EINVAL && bind_own_folder(from.c_str(), to.c_str(), true);
}

bool exists(std::string_view path) { return access(Path(old_root, path).c_str(), F_OK) == 0; }

/// Makes the writable folders, empty. Other folders may lie in them.
bool make_tmp() {
  return make_folders("/tmp") && make_folders("/dev") && make_folders("/dev/shm") &&
         bind(tmp, Path(new_root, "/tmp").c_str()) && bind(shm, Path(new_root, "/dev/shm").c_str());
}

/// Makes everything but /tmp and /dev/shm read-only.
bool close_all_but_tmp() {
  if (!change_mounts(new_root.data(), AT_RECURSIVE, MOUNT_ATTR_RDONLY, 0)) return false;
  return change_mounts(Path(new_root, "/tmp").c_str(), 0, 0, MOUNT_ATTR_RDONLY) &&
         change_mounts(Path(new_root, "/dev/shm").c_str(), 0, 0, MOUNT_ATTR_RDONLY);
}

bool make_rooms(const Rooms& rooms) {
  const bool has_folder = *rooms.folder != '\0';
  if (!make_tmp() || !show_all(rooms) || !make_devices() || !make_proc()) return false;
  if ((has_folder && !make_folders(rooms.folder)) || !hide_all(rooms, false)) return false;
  // As outside, a start in a missing folder fails.
  if (exists(rooms.directory) && !make_folders(rooms.directory)) return false;
  if (!close_all_but_tmp()) return false;
  return !has_folder || (make_own_folder(rooms) && hide_all(rooms, true));
}

/// A tmpfs as the root, with the old root below it.
bool enter_workshop(std::uint64_t room) {
  if (mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return false;
  if (!mount_tmpfs("/tmp", room) || chdir("/tmp") != 0) return false;
  if (mkdir("old", 0755) != 0 || syscall(SYS_pivot_root, ".", "old") != 0 || chdir("/") != 0) return false;
  for (const char* folder : {new_root.data(), tmp, shm, upper, work, lower_folder, no_folder})
    if (mkdir(folder, 0755) != 0) return false;
  chmod(tmp, 01777);
  chmod(shm, 01777);
  return make_file(no_file) && mount_tmpfs(new_root.data(), 0);
}

/// Leaves the old root and everything that was mounted there.
bool leave_workshop() {
  if (chdir(new_root.data()) != 0 || syscall(SYS_pivot_root, ".", ".") != 0) return false;
  return umount2(".", MNT_DETACH) == 0 && chdir("/") == 0;
}

}  // namespace

bool enter_new_root(const Rooms& rooms) {
  const mode_t usual = umask(0);
  const bool good = unshare(CLONE_NEWNS) == 0 && enter_workshop(rooms.room) && make_rooms(rooms) && leave_workshop();
  umask(usual);
  return good;
}

}  // namespace labmouse
