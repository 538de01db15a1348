#include "labmouse/external/survey.hpp"

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

#include "labmouse/external/short_text.hpp"
#include "labmouse/functions/parse_number.hpp"

namespace labmouse {
namespace {

// Most of this runs in the keeper, so it uses only async-signal-safe functions.

constexpr std::size_t portion = 4096;

int open_of(pid_t process, std::string_view name) {
  ShortText path;
  path << "/proc/" << static_cast<std::uint64_t>(process) << "/" << name;
  return open(path.c_str(), O_RDONLY | O_CLOEXEC);
}

/// The beginning of a /proc file of a process; empty if it cannot be read.
class Facts {
 public:
  Facts(pid_t process, std::string_view name) : Facts(open_of(process, name)) {}
  explicit Facts(int file) {
    if (file < 0) return;
    size_ = std::max<ssize_t>(0, read(file, text_.data(), text_.size()));
    close(file);
  }

  /// The whole number after that word; 0 if the word is missing.
  std::uint64_t number_after(std::string_view word) const {
    const std::string_view text = this->text();
    const auto at = text.find(word);
    return at == std::string_view::npos ? 0 : number(text.substr(at + word.size()));
  }
  /// The whole number after so many words.
  std::uint64_t number_behind(int words) const { return number(behind(text(), words)); }
  /// The part of `stat` after the process name, which may contain any character: state and numbers.
  std::string_view behind_name() const {
    const std::string_view text = this->text();
    const auto end = text.rfind(')');
    return end == std::string_view::npos ? "" : text.substr(std::min(end + 2, text.size()));
  }
  static std::uint64_t number_behind(std::string_view text, int words) { return number(behind(text, words)); }

 private:
  std::string_view text() const { return {text_.data(), static_cast<std::size_t>(size_)}; }
  static std::string_view behind(std::string_view text, int words) {
    for (; words > 0 && !text.empty(); --words) text.remove_prefix(std::min(text.find(' '), text.size() - 1) + 1);
    return text;
  }
  static std::uint64_t number(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return take_whole<std::uint64_t>(text).value_or(0);
  }

  std::array<char, portion> text_{};
  ssize_t size_ = 0;
};

std::uint64_t written_by(pid_t process) {
  const Facts facts(process, "io");
  // The first counts bytes of write calls, the second written pages of files, including memory-mapped ones.
  return std::max(facts.number_after("wchar: "), facts.number_after("\nwrite_bytes: "));
}

std::uint64_t memory_of(pid_t process, bool shares) {
  constexpr std::uint64_t kib = 1024;
  if (shares) return Facts(process, "smaps_rollup").number_after("\nPss: ") * kib;
  const Facts facts(process, "status");
  return (facts.number_after("\nRssAnon:") + facts.number_after("\nRssShmem:") + facts.number_after("\nVmSwap:")) * kib;
}

/// List of found processes, which is also the queue of the search.
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

std::chrono::nanoseconds ticks(std::uint64_t count) {
  constexpr std::int64_t second = 1'000'000'000;
  static const std::int64_t in_a_second = sysconf(_SC_CLK_TCK);
  return std::chrono::nanoseconds(static_cast<std::int64_t>(count) * (second / in_a_second));
}

/// Adds the state and the waiting time of one thread.
void add_time(int tasks, const char* thread, TreeTime& sum) {
  ShortText stat, schedule;
  stat << thread << "/stat";
  schedule << thread << "/schedstat";
  const Facts facts(openat(tasks, stat.c_str(), O_RDONLY | O_CLOEXEC));
  const std::string_view state = facts.behind_name().substr(0, 1);
  sum.is_busy = sum.is_busy || state == "R" || state == "D";
  const Facts waits(openat(tasks, schedule.c_str(), O_RDONLY | O_CLOEXEC));
  sum.waited += std::chrono::nanoseconds(waits.number_behind(1));
}

/// Adds the processor time of a process and of its reaped children; for the root only that of the children.
void add_work(pid_t process, bool is_root, TreeTime& sum) {
  // Behind the name: utime, stime, cutime and cstime.
  constexpr int own = 11, of_children = 13;
  const Facts facts(process, "stat");
  const std::string_view text = facts.behind_name();
  const auto both = [&](int word) {
    return ticks(Facts::number_behind(text, word) + Facts::number_behind(text, word + 1));
  };
  sum.worked += both(of_children) + (is_root ? std::chrono::nanoseconds(0) : both(own));
  sum.worked_before += both(of_children);
}

/// Adds the children of one thread; false if they cannot be read.
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

/// Calls `take` for each thread with a descriptor of the `task` folder and the thread's name; false if it cannot be
/// read.
template <class Take>
bool for_each_thread(pid_t process, const Take& take) {
  const int tasks = open_of(process, "task");
  if (tasks < 0) return false;
  alignas(dirent64) std::array<char, portion> entries{};
  for (long size; (size = syscall(SYS_getdents64, tasks, entries.data(), entries.size())) > 0;)
    for (long at = 0; at < size;) {
      const auto* entry = reinterpret_cast<const dirent64*>(entries.data() + at);
      if (entry->d_name[0] != '.') take(tasks, entry->d_name);
      at += entry->d_reclen;
    }
  close(tasks);
  return true;
}

/// Adds the children of all threads of a process; false if they cannot be read.
bool add_children(pid_t process, Found& found) {
  bool all = true;
  const bool known = for_each_thread(process, [&](int tasks, const char* thread) {
    if (!add_children(tasks, thread, found)) all = false;
  });
  return known && all;
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

TreeTime time_of_tree(pid_t root) {
  TreeTime sum;
  Found found(std::numeric_limits<std::size_t>::max());
  add_work(root, true, sum);
  add_children(root, found);
  for (std::size_t i = 0; i < found.count(); ++i) {
    add_work(found.at(i), false, sum);
    for_each_thread(found.at(i), [&](int tasks, const char* thread) {
      add_time(tasks, thread, sum);
      add_children(tasks, thread, found);
    });
  }
  return sum;
}

std::chrono::nanoseconds waited_for_processor() {
  const Facts facts(open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC));
  return std::chrono::nanoseconds(facts.number_behind(1));
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
