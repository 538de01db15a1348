#include "labmouse/guests/survey.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <limits>
#include <string_view>

#include "labmouse/guests/short_text.hpp"

namespace labmouse {
namespace {

// All of this runs in the keeper: only functions that are safe in a signal handler.

constexpr std::size_t portion = 4096;

int open_of(pid_t process, std::string_view name) {
  ShortText path;
  path << "/proc/" << static_cast<std::uint64_t>(process) << "/" << name;
  return open(path.c_str(), O_RDONLY | O_CLOEXEC);
}

/// The beginning of a file about a process; empty where there is none, or none for us.
class Facts {
 public:
  Facts(pid_t process, std::string_view name) {
    const int file = open_of(process, name);
    if (file < 0) return;
    size_ = std::max<ssize_t>(0, read(file, text_.data(), text_.size()));
    close(file);
  }

  /// The whole number behind that word; 0 where it does not stand there.
  std::uint64_t number_after(std::string_view word) const {
    const std::string_view text = this->text();
    const auto at = text.find(word);
    return at == std::string_view::npos ? 0 : number(text.substr(at + word.size()));
  }

 private:
  std::string_view text() const { return {text_.data(), static_cast<std::size_t>(size_)}; }
  static std::uint64_t number(std::string_view text) {
    std::uint64_t value = 0;
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }

  std::array<char, portion> text_{};
  ssize_t size_ = 0;
};

std::uint64_t written_by(pid_t process) {
  const Facts facts(process, "io");
  // The first counts what went to files and pipes by way of calls, the second pages of files, however they came.
  return std::max(facts.number_after("wchar: "), facts.number_after("\nwrite_bytes: "));
}

std::uint64_t memory_of(pid_t process, bool shares) {
  constexpr std::uint64_t kib = 1024;
  if (shares) return Facts(process, "smaps_rollup").number_after("\nPss: ") * kib;
  const Facts facts(process, "status");
  return (facts.number_after("\nRssAnon:") + facts.number_after("\nRssShmem:") + facts.number_after("\nVmSwap:")) * kib;
}

/// Those whose descendants are still to be looked for, and all that were found.
class Found {
 public:
  explicit Found(std::size_t most) : most_(std::min(most, all_.size())) {}

  void add(pid_t process) {
    if (count_ < most_)
      all_[count_++] = process;
    else
      is_full_ = true;
  }
  std::size_t count() const { return count_; }
  pid_t at(std::size_t i) const { return all_[i]; }
  bool is_full() const { return is_full_; }

 private:
  std::array<pid_t, 4096> all_{};
  std::size_t most_, count_ = 0;
  bool is_full_ = false;
};

/// Adds the children that one thread started; false where they cannot be known.
bool add_children(int tasks, const char* thread, Found& found) {
  ShortText path;
  path << thread << "/children";
  const int list = openat(tasks, path.c_str(), O_RDONLY | O_CLOEXEC);
  // A thread that ended meanwhile has none.
  if (list < 0) return errno == ENOENT && faccessat(tasks, thread, F_OK, 0) != 0;
  for_each_number(list, [&](pid_t child) { found.add(child); });
  close(list);
  return true;
}

/// Adds the children of a process, whichever of its threads started them; false where they cannot be known.
bool add_children(pid_t process, Found& found) {
  const int tasks = open_of(process, "task");
  if (tasks < 0) return false;
  bool all = true;
  alignas(dirent64) std::array<char, portion> entries{};
  for (long size; (size = syscall(SYS_getdents64, tasks, entries.data(), entries.size())) > 0;)
    for (long at = 0; at < size;) {
      const auto* entry = reinterpret_cast<const dirent64*>(entries.data() + at);
      if (entry->d_name[0] != '.' && !add_children(tasks, entry->d_name, found)) all = false;
      at += entry->d_reclen;
    }
  close(tasks);
  return all;
}

}  // namespace

Holdings survey(pid_t root, int most, bool shares) {
  Holdings sum;
  Found found(static_cast<std::size_t>(most));
  sum.written = written_by(root);
  add_children(root, found);
  for (std::size_t i = 0; i < found.count() && !found.is_full(); ++i) {
    sum.memory += memory_of(found.at(i), shares);
    sum.written += written_by(found.at(i));
    add_children(found.at(i), found);
  }
  sum.processes = static_cast<int>(found.count());
  sum.is_full = found.is_full();
  return sum;
}

bool kill_descendants(pid_t root) {
  Found found(std::numeric_limits<std::size_t>::max());
  bool all = add_children(root, found);
  for (std::size_t i = 0; i < found.count(); ++i) {
    if (kill(found.at(i), SIGKILL) != 0 && errno != ESRCH) all = false;
    add_children(found.at(i), found);
  }
  return all;
}

TreeLimit TreeWatch::look() {
  pause_ = quick;
  Holdings now = survey(root_, limits_.processes, false);
  if (now.is_full) return TreeLimit::processes;
  if (now.written > limits_.written) return TreeLimit::written;
  if (now.memory <= limits_.memory) return TreeLimit::none;
  now = survey(root_, limits_.processes, true);
  pause_ = slow;
  return now.memory > limits_.memory ? TreeLimit::memory : TreeLimit::none;
}

}  // namespace labmouse
