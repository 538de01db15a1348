// A child process with limits: started without a shell, and gone with all that it started when its object goes.
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

/// What ended a wait.
enum class ExternalEvent {
  output,       ///< there are more bytes in lines(), or fewer unsent()
  ended,        ///< the program ended and its output was read: status() says how
  left,         ///< the program ended, and others that it started hold its output open
  closed,       ///< the program runs on without standard output
  timeout,      ///< nothing until the deadline
  exceeded,     ///< it and what it started passed a limit, and were ended: exceeded() says which
  interrupted,  ///< Launch::stop was raised
};

/// How a program ended: by itself with a code, or by a signal.
struct ExitStatus {
  int code = 0;
  int signal = 0;  ///< 0: by itself

  friend constexpr bool operator==(const ExitStatus&, const ExitStatus&) = default;
};

/// "exit code 1", "signal 11 (Segmentation fault)".
std::string describe(const ExitStatus& status);

/// "were more than 64 processes (--processes)": what an external mouse and all that it started did.
std::string describe(TreeLimit limit, const ExternalLimits& limits);

/// One external mouse. A keeper process between it and us gathers all that the external mouse leaves behind, even what
/// left its process group, and ends it when this object goes or when our own process dies. Only an external mouse that
/// kills its keeper, or that runs programs with the rights of another user, can leave something behind. Linux only.
class ExternalProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// Starts it; where that fails, error() says why, and every wait returns `ended`. From the first start on, the
  /// program ignores SIGPIPE where it had no handler for it.
  explicit ExternalProcess(const Launch& launch);
  ExternalProcess(const ExternalProcess&) = delete;
  ExternalProcess& operator=(const ExternalProcess&) = delete;
  ~ExternalProcess() { end(std::chrono::milliseconds(0)); }

  /// Why it could not be started; empty where it was.
  const std::string& error() const { return error_; }

  /// Hands bytes to its standard input: as many as it takes now, the rest in later waits.
  void send(std::string_view bytes);
  /// Bytes that were sent and that it did not take yet.
  std::size_t unsent() const { return unsent_.size() - sent_; }
  /// Whether it closed its standard input; what is sent then is dropped.
  bool deaf() const { return input_ < 0; }

  /// Waits for output and reads one portion of it into lines(), or for room for what is unsent.
  ExternalEvent wait(Clock::time_point deadline);
  LineBuffer& lines() { return lines_; }

  /// Processor time that the program itself took so far, without that of processes that it started.
  std::chrono::nanoseconds processor_time();

  /// What it and all that it started did with their time so far.
  TreeTime tree_time() { return time_of_tree(sandboxed_ ? child_ : keeper_); }

  /// How it ended; nothing while it runs.
  const std::optional<ExitStatus>& status() const { return status_; }
  /// The limit over its whole tree of processes that it passed.
  TreeLimit exceeded() const { return exceeded_; }

  /// Closes its standard input and gives it that long to end by itself (none: it is not even told), then ends it with
  /// all that it started. What it still writes to its standard error is kept; its output is dropped.
  void end(std::chrono::milliseconds grace);

  /// The last bytes of its standard error, as they came; of a program that runs, up to now.
  std::string_view errors();

 private:
  struct Pipes;
  void start(const Launch& launch, Pipes& pipes);
  /// Polls once, for so long at most; true where output came or went.
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
  pid_t child_ = -1;  ///< of the keeper: the external mouse, or in a sandbox its parent
  pid_t external_ = -1;
  bool sandboxed_ = false;
  std::chrono::nanoseconds processor_time_{};  ///< the last that was known
  int input_ = -1, output_ = -1, errors_end_ = -1, status_end_ = -1, leash_ = -1;
  LineBuffer lines_;
  std::string portion_;  ///< room for one read
  std::string unsent_;
  std::size_t sent_ = 0;    ///< bytes of unsent_ that are on their way
  bool writes_on_ = false;  ///< whether it wrote a little just now and waits for no reply
  std::string errors_;
  std::optional<ExitStatus> status_;
  TreeLimit exceeded_ = TreeLimit::none;
  Clock::time_point closed_due_ = Clock::time_point::max();  ///< when it is sure that it closed its output and runs on
};

}  // namespace labmouse
