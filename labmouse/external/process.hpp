// A child process with limits, started without a shell. The destructor ends it and all its descendants.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "labmouse/external/launch.hpp"
#include "labmouse/external/line_buffer.hpp"
#include "labmouse/external/survey.hpp"

namespace labmouse {

/// Result of a wait.
enum class ExternalEvent {
  output,       ///< there are more bytes in lines(), or fewer unsent()
  ended,        ///< the program ended and its output was read: status() says how
  left,         ///< the program ended, but a descendant keeps its output open
  closed,       ///< the program closed its standard output, but keeps running
  timeout,      ///< nothing happened until the deadline
  exceeded,     ///< its process tree exceeded a limit, and was ended: exceeded() says which
  interrupted,  ///< Launch::stop became true
};

/// How a program ended: with an exit code, or by a signal.
struct ExitStatus {
  int code = 0;
  int signal = 0;  ///< 0: it exited

  friend constexpr bool operator==(const ExitStatus&, const ExitStatus&) = default;
};

/// "exit code 1", "signal 11 (Segmentation fault)".
std::string describe(const ExitStatus& status);

/// "were more than 64 processes (--processes)": how a process tree exceeded a limit.
std::string describe(TreeLimit limit, const ExternalLimits& limits);

/// One external mouse. A keeper process adopts all descendants of the mouse, even those outside of its process group,
/// and ends them when this object is destroyed or the calling process dies. Only a mouse that kills its keeper, or runs
/// programs with the rights of another user, can leave processes behind. Linux only.
class ExternalProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// Starts it. If that fails, error() says why, and every wait returns `ended`. The first start makes the calling
  /// program ignore SIGPIPE, unless it has a handler.
  explicit ExternalProcess(const Launch& launch);
  ExternalProcess(const ExternalProcess&) = delete;
  ExternalProcess& operator=(const ExternalProcess&) = delete;
  ~ExternalProcess() { end(std::chrono::milliseconds(0)); }

  /// Why it could not be started; empty if it was started.
  const std::string& error() const { return error_; }

  /// Writes bytes to its standard input: as many as fit now, the rest in later waits.
  void send(std::string_view bytes);
  /// Number of bytes not yet written to its input.
  std::size_t unsent() const { return unsent_.size() - sent_; }
  /// Whether it closed its standard input; bytes sent later are dropped.
  bool deaf() const { return input_ < 0; }

  /// Waits for output, and reads one portion into lines(); or waits until unsent bytes can be written.
  ExternalEvent wait(Clock::time_point deadline);
  LineBuffer& lines() { return lines_; }

  /// Processor time of the program itself so far, without its descendants.
  std::chrono::nanoseconds processor_time();

  /// Times of its process tree so far.
  TreeTime tree_time() { return time_of_tree(sandboxed_ ? child_ : keeper_); }

  /// How it ended; nullopt while it runs.
  const std::optional<ExitStatus>& status() const { return status_; }
  /// The limit that its process tree exceeded.
  TreeLimit exceeded() const { return exceeded_; }

  /// Closes its standard input, waits that long for its end (0: kills it at once), then kills its process tree. Its
  /// last standard error is kept; its output is dropped.
  void end(std::chrono::milliseconds grace);

  /// The last bytes of its standard error so far.
  std::string_view errors();

 private:
  struct Pipes;
  void start(const Launch& launch, Pipes& pipes);
  /// Polls once, with that timeout. Returns whether bytes were read or written.
  bool look(Clock::duration left);
  void write_some();
  void drop_input();
  bool read_output();
  bool read_errors();
  void read_last_errors();
  void read_status();
  void wait_for_its_end(Clock::time_point until);

  ExternalLimits limits_;
  const std::atomic<bool>* stop_;
  std::string error_;
  pid_t keeper_ = -1;
  pid_t child_ = -1;  ///< child of the keeper: the external mouse, or in a sandbox its parent
  pid_t external_ = -1;
  bool sandboxed_ = false;
  std::chrono::nanoseconds processor_time_{};  ///< last measured value
  int input_ = -1, output_ = -1, errors_end_ = -1, status_end_ = -1, leash_ = -1;
  LineBuffer lines_;
  std::string portion_;  ///< buffer for one read
  std::string unsent_;
  std::size_t sent_ = 0;    ///< bytes of unsent_ that are already written
  bool writes_on_ = false;  ///< whether it writes small portions without waiting for replies
  std::string errors_;
  std::optional<ExitStatus> status_;
  TreeLimit exceeded_ = TreeLimit::none;
  Clock::time_point closed_due_ = Clock::time_point::max();  ///< deadline of its end after it closed its output
};

}  // namespace labmouse
