#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include "labmouse/lab/system/descriptor.hpp"
#include "labmouse/lab/system/file_problems.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/streams.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

std::string unwritable(int error_number) { return error_number == 0 ? "" : "cannot write: " + cause_of(error_number); }

/// Where a path leads, or why nothing can be written there.
struct Target {
  fs::path path;
  std::optional<mode_t> mode;  ///< of the file that is there
  bool stream = false;
  std::string error;
};

Target refused(int error) { return {{}, std::nullopt, false, unwritable(error)}; }

/// The end of a chain of links, which need not exist. Links stay that way, and their target is what changes.
fs::path end_of_links(fs::path path) {
  std::error_code error;
  while (fs::is_symlink(fs::symlink_status(path, error))) path = path.parent_path() / fs::read_symlink(path, error);
  return path;
}

Target target_of(const std::string& path) {
  if (path.empty()) return {{}, std::nullopt, false, "the path of the file is empty"};
  if (path.back() == '/') return refused(EISDIR);
  if (descriptor_to_write(path)) return {path, std::nullopt, true, {}};
  std::error_code error;
  if (const fs::path folder = fs::path(path).parent_path(); !folder.empty()) fs::create_directories(folder, error);
  if (error) return refused(error.value());
  struct stat status {};
  const bool exists = stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) return refused(errno);  // links in a circle, too
  if (!exists) return {end_of_links(path), std::nullopt, false, {}};
  if (S_ISDIR(status.st_mode)) return refused(EISDIR);
  if (!S_ISREG(status.st_mode)) return {path, std::nullopt, true, {}};
  // A rename would replace a file that its owner has made read-only.
  if (faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) return refused(errno);
  return {end_of_links(path), status.st_mode & mode_t{07777}, false, {}};
}

int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = write(descriptor, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

/// Writes into what must not be replaced.
int write_through(const std::string& path, std::string_view content) {
  if (const auto descriptor = descriptor_to_write(path)) return write_all(*descriptor, content);
  Descriptor opened = Descriptor::opened(open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (opened.number() < 0) return errno;
  const int error = write_all(opened.number(), content);
  return error != 0 ? error : opened.close();
}

/// While one of these lives, no signal ends this thread between a new file and its place.
class Undisturbed {
 public:
  Undisturbed() {
    sigset_t ends;
    sigemptyset(&ends);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ends, number);
    pthread_sigmask(SIG_BLOCK, &ends, &before_);
  }
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;
  ~Undisturbed() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

/// A new file in the target's folder, removed when this goes unless it was put into its place. Its name is short,
/// whatever the target's is.
class Part {
 public:
  explicit Part(const Target& target)
      : folder_(target.path.parent_path()), file_(Descriptor::opened(make(target.mode))) {}
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;
  ~Part() {
    if (!path_.empty()) unlink(path_.c_str());
  }

  int error() const { return error_; }

  int fill(std::string_view content) {
    const int error = write_all(file_.number(), content);
    return error != 0 ? error : file_.close();
  }

  int put(const fs::path& place) {
    if (std::rename(path_.c_str(), place.c_str()) != 0) return errno;
    path_.clear();
    return 0;
  }

 private:
  int make(const std::optional<mode_t>& mode) {
    static std::atomic<unsigned> parts{0};
    int number = -1;
    // Another process of that number may have left its part when it was killed.
    do {
      path_ = (folder_ / fmt::format(".labmouse-{}-{}.part", getpid(), parts++)).string();
      number = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode.value_or(0666));
    } while (number < 0 && errno == EEXIST);
    if (number < 0) {
      error_ = errno;
      path_.clear();
    } else if (mode) {
      // With the permissions of the file that it replaces; where that fails they are narrower, by the umask.
      [[maybe_unused]] const int failed = fchmod(number, *mode);
    }
    return number;
  }

  fs::path folder_;
  std::string path_;
  int error_ = 0;
  Descriptor file_;
};

int replace(const Target& target, std::string_view content) {
  const Undisturbed undisturbed;
  Part part(target);
  if (part.error() != 0) return part.error();
  const int error = part.fill(content);
  return error != 0 ? error : part.put(target.path);
}

/// Whether a descriptor is open for writing.
int check_descriptor(int descriptor) {
  const int flags = fcntl(descriptor, F_GETFL);
  if (flags < 0) return errno;
  return (flags & O_ACCMODE) == O_RDONLY ? EBADF : 0;
}

}  // namespace

std::string write_file(const std::string& path, std::string_view content) {
  const Target target = target_of(path);
  if (!target.error.empty()) return target.error;
  return unwritable(target.stream ? write_through(path, content) : replace(target, content));
}

std::string check_writable(const std::string& path) {
  const Target target = target_of(path);
  if (!target.error.empty()) return target.error;
  if (const auto descriptor = descriptor_to_write(path)) return unwritable(check_descriptor(*descriptor));
  if (target.stream) return "";
  const Undisturbed undisturbed;
  return unwritable(Part(target).error());
}

}  // namespace labmouse
