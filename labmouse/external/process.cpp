#include "labmouse/external/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fstream>
#include <mutex>
#include <thread>
#include <utility>

#include "labmouse/external/command_line.hpp"
#include "labmouse/external/keeper.hpp"
#include "labmouse/external/sandbox.hpp"
#include "labmouse/external/surroundings.hpp"
#include "labmouse/functions/parse_number.hpp"

namespace labmouse {
namespace {

using namespace std::chrono_literals;

/// Interval at which a wait checks Launch::stop, because a signal wakes only one thread.
constexpr auto glance = 10ms;
/// An ending program closes its output first. If it has not ended after this time, it only closed its output.
constexpr auto between_both = 500ms;
/// Pause before the next read from a mouse that writes without waiting for replies. A program that writes line
/// by line needs about this time or more to fill its pipe.
constexpr auto nap = 1ms;
/// Portions of fewer bytes count as small.
constexpr ssize_t small_portion = 4096;

/// A write to an ended mouse must return an error, not kill the calling program.
void ignore_broken_pipes() {
  static std::once_flag once;
  std::call_once(once, [] {
    struct sigaction now {};
    if (sigaction(SIGPIPE, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) std::signal(SIGPIPE, SIG_IGN);
  });
}

void close_end(int& end) {
  if (end >= 0) ::close(std::exchange(end, -1));
}

ExitStatus exit_status(int wait_status) {
  if (WIFSIGNALED(wait_status)) return {0, WTERMSIG(wait_status)};
  return {WEXITSTATUS(wait_status), 0};
}

bool same_variable(std::string_view one, std::string_view other) {
  return one.substr(0, one.find('=')) == other.substr(0, other.find('='));
}

/// Whether a mouse inherits the variable. In a sandbox these are only variables that say how and where programs run,
/// because any other may hold a secret, such as the seed of hidden mazes or a password. Elsewhere the mouse can find
/// them anyway; in `_` a shell leaves the path of labmouse, and what is named after labmouse may name mazes.
bool is_inherited(std::string_view variable, bool sandbox) {
  constexpr std::array<std::string_view, 14> names = {
      "HOME",  "JAVA_HOME", "LANG",   "LANGUAGE", "LD_LIBRARY_PATH", "LOGNAME", "NODE_PATH", "PATH",
      "SHELL", "TERM",      "TMPDIR", "TZ",       "VIRTUAL_ENV",     "USER"};
  constexpr std::array<std::string_view, 4> beginnings = {"LC_", "NVM_", "PYENV_", "PYTHON"};
  const std::string_view name = variable.substr(0, variable.find('='));
  if (!sandbox) return name != "_" && !name.starts_with("LABMOUSE_");
  return std::find(names.begin(), names.end(), name) != names.end() || name.ends_with("_NUM_THREADS") ||
         std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return name.starts_with(beginning); });
}

/// The inherited environment with the launch's variables, for exec; points into both.
std::vector<char*> environment_of(const Launch& launch) {
  std::vector<char*> variables;
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (is_inherited(*variable, launch.sandbox) &&
        std::none_of(launch.environment.begin(), launch.environment.end(),
                     [&](const std::string& own) { return same_variable(own, *variable); }))
      variables.push_back(*variable);
  for (const std::string& own : launch.environment) variables.push_back(const_cast<char*>(own.c_str()));
  variables.push_back(nullptr);
  return variables;
}

/// The Rooms of a launch, with the texts and lists that they point to.
class SandboxPlan {
 public:
  SandboxPlan(const Launch& launch, const std::string& program)
      : around_(launch.surroundings ? launch.surroundings
                                    : std::make_shared<const Surroundings>(surroundings_of(launch, program))) {
    hidden_ = around_->hidden;
    if (launch.hidden)
      for (std::string& path : seen_of(*around_, *launch.hidden->paths())) hidden_.push_back(std::move(path));
    for (const std::string& path : around_->visible) visible_texts_.push_back(path.c_str());
    for (const auto& [path, target] : around_->links) links_.push_back({path.c_str(), target.c_str()});
    for (const std::string& path : hidden_) hidden_texts_.push_back(path.c_str());
    visible_texts_.push_back(nullptr);
    links_.emplace_back();
    hidden_texts_.push_back(nullptr);
    rooms_ = {around_->folder.c_str(),
              around_->directory.c_str(),
              visible_texts_.data(),
              links_.data(),
              hidden_texts_.data(),
              launch.limits.written,
              launch.keeps_folder ? FolderUse::keep : usual_folder_use()};
  }
  const Rooms& rooms() const { return rooms_; }

 private:
  std::shared_ptr<const Surroundings> around_;
  std::vector<std::string> hidden_;
  std::vector<const char*> visible_texts_, hidden_texts_;
  std::vector<Rooms::Link> links_;
  Rooms rooms_;
};

/// The child of a sandbox's first process; -1 if there is none yet.
pid_t only_child(pid_t parent) {
  std::string children;
  std::getline(std::ifstream(fmt::format("/proc/{0}/task/{0}/children", parent)), children);
  std::string_view rest = children;
  const pid_t child = take_whole<pid_t>(rest).value_or(-1);
  return child > 0 ? child : -1;
}

}  // namespace

std::string describe(const ExitStatus& status) {
  if (status.signal == 0) return fmt::format("exit code {}", status.code);
  const char* name = sigdescr_np(status.signal);
  return fmt::format("signal {} ({})", status.signal, name == nullptr ? "unknown" : name);
}

std::string describe(TreeLimit limit, const ExternalLimits& limits) {
  constexpr int mib_bits = 20;
  switch (limit) {
    case TreeLimit::processes:
      return fmt::format("were more than {} processes (--processes)", limits.processes);
    case TreeLimit::memory:
      return fmt::format("held more than {} MiB of memory (--memory)", limits.memory >> mib_bits);
    case TreeLimit::written:
      return fmt::format("wrote more than {} MiB (--written)", limits.written >> mib_bits);
    case TreeLimit::none:
      break;
  }
  return "";
}

/// The pipes, closed by exec in every child; the destructor closes remaining ends.
struct ExternalProcess::Pipes {
  struct Pair {
    int read = -1, write = -1;
  };
  Pair input, output, errors, failure, status, leash;

  bool open() {
    for (Pair* pair : all()) {
      std::array<int, 2> ends{};
      if (pipe2(ends.data(), O_CLOEXEC) != 0) return false;
      *pair = {ends[0], ends[1]};
    }
    return true;
  }
  std::array<Pair*, 6> all() { return {&input, &output, &errors, &failure, &status, &leash}; }
  ~Pipes() {
    for (Pair* pair : all())
      for (const int end : {pair->read, pair->write})
        if (end >= 0) ::close(end);
  }
};

ExternalProcess::ExternalProcess(const Launch& launch)
    : limits_(launch.limits),
      stop_(launch.stop),
      lines_(launch.limits.longest_line),
      portion_(std::size_t{1} << 16U, '\0') {
  ignore_broken_pipes();
  Pipes pipes;
  if (launch.words.empty())
    error_ = "the command is empty";
  else if (!pipes.open())
    error_ = fmt::format("cannot create a pipe: {}", std::strerror(errno));
  else
    start(launch, pipes);
  if (!error_.empty()) end(0ms);
}

void ExternalProcess::start(const Launch& launch, Pipes& pipes) {
  const std::string path = program_path(launch.words.front(), launch.directory);
  if (path.empty()) {
    error_ = fmt::format("program '{}' not found", launch.words.front());
    return;
  }
  std::vector<char*> words;
  for (const std::string& word : launch.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  std::vector<char*> environment = environment_of(launch);
  const KeptEnds ends = {pipes.input.read,    pipes.output.write, pipes.errors.write,
                         pipes.failure.write, pipes.status.write, pipes.leash.read};
  std::optional<SandboxPlan> plan;
  if (launch.sandbox) plan.emplace(launch, path);
  const KeptExternal external = {path.c_str(),       words.data(),
                                 environment.data(), launch.directory.c_str(),
                                 launch.limits,      plan ? &plan->rooms() : nullptr};
  keeper_ = fork();
  if (keeper_ == 0) keep_external(external, ends);
  if (keeper_ < 0) {
    error_ = fmt::format("cannot create a process: {}", std::strerror(errno));
    return;
  }
  input_ = std::exchange(pipes.input.write, -1);
  output_ = std::exchange(pipes.output.read, -1);
  errors_end_ = std::exchange(pipes.errors.read, -1);
  status_end_ = std::exchange(pipes.status.read, -1);
  leash_ = std::exchange(pipes.leash.write, -1);
  // Now only the keeper and the mouse hold these ends, so each pipe reports its end when both have closed it.
  for (int* end : {&pipes.input.read, &pipes.output.write, &pipes.errors.write, &pipes.failure.write,
                   &pipes.status.write, &pipes.leash.read})
    close_end(*end);
  int reason = 0;
  while (read(pipes.failure.read, &reason, sizeof reason) < 0 && errno == EINTR) {
  }
  if (reason != 0) error_ = fmt::format("cannot start '{}': {}", launch.words.front(), std::strerror(reason));
  // The keeper writes this message as soon as it has a child, so this wait is short.
  while (reason == 0 && child_ < 0 && status_end_ >= 0) read_status();
  sandboxed_ = launch.sandbox;
  if (!sandboxed_) external_ = child_;
  for (const int end : {input_, output_, errors_end_, status_end_}) fcntl(end, F_SETFL, O_NONBLOCK);
}

std::chrono::nanoseconds ExternalProcess::processor_time() {
  clockid_t clock = 0;
  timespec time{};
  if (external_ < 0) external_ = only_child(child_);
  // After the program was reaped, its process id may be reused.
  if (!status_ && external_ > 0 && clock_getcpuclockid(external_, &clock) == 0 && clock_gettime(clock, &time) == 0)
    processor_time_ = std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
  return processor_time_;
}

void ExternalProcess::send(std::string_view bytes) {
  if (deaf()) return;
  // If earlier bytes are unsent, the pipe is full until look() finds room.
  const bool full = unsent() > 0;
  unsent_ += bytes;
  if (!full) write_some();
}

ExternalEvent ExternalProcess::wait(Clock::time_point deadline) {
  for (;;) {
    if (stop_ != nullptr && stop_->load()) return ExternalEvent::interrupted;
    if (status_ && output_ >= 0 && read_output()) return ExternalEvent::output;
    if (exceeded_ != TreeLimit::none) return ExternalEvent::exceeded;
    if (keeper_ < 0 || (status_ && output_ < 0)) return ExternalEvent::ended;
    // Where nothing that it started is left, the keeper of another mouse, forked just now, has the pipe for a moment.
    if (status_ && survey(sandboxed_ ? child_ : keeper_, 1, false).processes > 0) return ExternalEvent::left;
    const auto now = Clock::now();
    if (now >= closed_due_) return ExternalEvent::closed;
    if (now >= deadline) return ExternalEvent::timeout;
    if (std::exchange(writes_on_, false)) std::this_thread::sleep_for(std::min<Clock::duration>(nap, deadline - now));
    if (look(std::min({deadline, now + glance, closed_due_}) - now)) return ExternalEvent::output;
  }
}

bool ExternalProcess::look(Clock::duration left) {
  // The input is polled even without unsent bytes: an error means that its reader is gone.
  const short writable = unsent() > 0 ? POLLOUT : 0;
  std::array<pollfd, 4> ends = {
      {{output_, POLLIN, 0}, {errors_end_, POLLIN, 0}, {status_end_, POLLIN, 0}, {input_, writable, 0}}};
  const timespec time = {std::chrono::duration_cast<std::chrono::seconds>(left).count(),
                         std::chrono::duration_cast<std::chrono::nanoseconds>(left % 1s).count()};
  if (ppoll(ends.data(), ends.size(), &time, nullptr) <= 0) return false;
  const std::size_t before = unsent();
  if ((ends[3].revents & POLLERR) != 0)
    drop_input();
  else if (ends[3].revents != 0)
    write_some();
  if (ends[1].revents != 0) read_errors();
  if (ends[2].revents != 0) read_status();
  return (ends[0].revents != 0 && read_output()) || unsent() < before;
}

void ExternalProcess::write_some() {
  while (unsent() > 0) {
    const ssize_t count = write(input_, unsent_.data() + sent_, unsent());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) return;
    if (count < 0) return drop_input();
    sent_ += static_cast<std::size_t>(count);
    // Frees written bytes even if the mouse always leaves some unread.
    if (sent_ > unsent_.size() / 2) unsent_.erase(0, std::exchange(sent_, 0));
  }
  unsent_.clear();
  sent_ = 0;
}

void ExternalProcess::drop_input() {
  close_end(input_);
  unsent_.clear();
  sent_ = 0;
}

bool ExternalProcess::read_output() {
  const ssize_t count = read(output_, portion_.data(), portion_.size());
  if (count > 0) lines_.append(std::string_view(portion_).substr(0, static_cast<std::size_t>(count)));
  // A mouse that leaves replies unread, or closed its input, waits for none: do not wake up for each of its lines.
  writes_on_ = count > 0 && count < small_portion && (unsent() > 0 || deaf());
  if (count == 0) {
    close_end(output_);
    closed_due_ = Clock::now() + between_both;
  }
  return count > 0;
}

bool ExternalProcess::read_errors() {
  const ssize_t count = read(errors_end_, portion_.data(), portion_.size());
  if (count == 0) close_end(errors_end_);
  if (count <= 0) return false;
  errors_.append(portion_, 0, static_cast<std::size_t>(count));
  if (errors_.size() > limits_.kept_errors) errors_.erase(0, errors_.size() - limits_.kept_errors);
  return true;
}

std::string_view ExternalProcess::errors() {
  // At most what a pipe can hold, in case the program never stops writing.
  constexpr int portions = 16;
  for (int i = 0; i < portions && errors_end_ >= 0 && read_errors(); ++i) {
  }
  return errors_;
}

void ExternalProcess::read_last_errors() {
  // The pipe ends when the last process that could write to it has ended, which takes at most a moment.
  constexpr int moment = 200;  // milliseconds
  while (errors_end_ >= 0) {
    pollfd errors = {errors_end_, POLLIN, 0};
    if (poll(&errors, 1, moment) <= 0 || (!read_errors() && errors_end_ >= 0)) return;
  }
}

void ExternalProcess::read_status() {
  KeeperWord word;
  const ssize_t count = read(status_end_, &word, sizeof word);
  if (count < 0) return;
  if (count == sizeof word && word.kind == KeeperWord::Kind::first) {
    child_ = word.value;
    return;
  }
  close_end(status_end_);
  if (count == sizeof word && word.kind == KeeperWord::Kind::ended) {
    status_ = exit_status(word.value);
    if (status_->signal == SIGXFSZ) exceeded_ = TreeLimit::written;
    return;
  }
  if (count == sizeof word) exceeded_ = static_cast<TreeLimit>(word.value);
  // It was killed by its keeper or together with it (without a message): its remaining output is ignored.
  status_ = ExitStatus{0, SIGKILL};
  close_end(output_);
}

void ExternalProcess::end(std::chrono::milliseconds grace) {
  if (keeper_ < 0) return;
  if (grace > 0ms) wait_for_its_end(Clock::now() + grace);
  close_end(leash_);
  // Continues the keeper, in case the external mouse stopped it.
  kill(keeper_, SIGCONT);
  while (waitpid(keeper_, nullptr, 0) < 0 && errno == EINTR) {
  }
  keeper_ = -1;
  read_last_errors();
  if (status_end_ >= 0) read_status();
  for (int* end : {&input_, &output_, &errors_end_, &status_end_}) close_end(*end);
}

void ExternalProcess::wait_for_its_end(Clock::time_point until) {
  close_end(input_);
  for (auto now = Clock::now(); !status_ && now < until && (stop_ == nullptr || !stop_->load()); now = Clock::now()) {
    look(std::min<Clock::duration>(until - now, glance));
    // Its remaining output is dropped.
    lines_ = LineBuffer(limits_.longest_line);
  }
}

}  // namespace labmouse
