// Runs the program as a user does.
#pragma once

#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace labmouse::test {

inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Waits until that is so, for a minute at most. Returns whether it is.
inline bool patiently(const std::function<bool()>& done) {
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!done() && std::chrono::steady_clock::now() < patience) std::this_thread::yield();
  return done();
}

/// How a run of the program went.
struct Ended {
  int code = -1;  ///< exit code, or minus the signal that ended it
  std::string out;
  std::string err;
};

/// One run of the program in a folder, with its output in files, so that it never waits for a reader.
class Program {
 public:
  Program(const std::filesystem::path& folder, std::vector<std::string> arguments, const char* variable = nullptr)
      : out_(folder / ".out"), err_(folder / ".err") {
    arguments.insert(arguments.begin(), LABMOUSE_PROGRAM);
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    std::fflush(nullptr);  // or the child would write it once more
    child_ = fork();
    if (child_ != 0) return;
    if (variable != nullptr) putenv(const_cast<char*>(variable));
    if (chdir(folder.c_str()) != 0 || std::freopen(out_.c_str(), "wb", stdout) == nullptr ||
        std::freopen(err_.c_str(), "wb", stderr) == nullptr)
      _exit(126);
    execv(words[0], words.data());
    _exit(127);
  }

  void interrupt() const { signal(SIGINT); }
  void signal(int number) const { ::kill(child_, number); }
  void kill() const { ::kill(child_, SIGKILL); }

  /// Whether the program has come so far that an interrupt does not simply end it.
  bool handles_interrupts() const {
    const std::string status = content_of("/proc/" + std::to_string(child_) + "/status");
    const auto caught = status.find("SigCgt:");
    return caught != std::string::npos &&
           (std::stoull(status.substr(caught + 7), nullptr, 16) >> (SIGINT - 1) & 1U) != 0;
  }

  /// The most memory that it has had so far, in kB; 0 where the system does not say.
  long most_memory() const {
    const std::string status = content_of("/proc/" + std::to_string(child_) + "/status");
    const auto most = status.find("VmHWM:");
    return most == std::string::npos ? 0 : std::stol(status.substr(most + 6));
  }

  /// Whether it waits for something, such as the other end of a pipe.
  bool sleeps() const {
    return content_of("/proc/" + std::to_string(child_) + "/status").find("State:\tS") != std::string::npos;
  }

  /// Whether it has not ended yet; wait() says how it did.
  bool runs() const {
    siginfo_t ended{};
    return waitid(P_PID, static_cast<id_t>(child_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0;
  }

  Ended wait() const {
    int status = 0;
    waitpid(child_, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), content_of(out_), content_of(err_)};
  }

 private:
  std::filesystem::path out_, err_;
  pid_t child_ = 0;
};

/// The exit code of the program whose reader has gone before it prints.
inline int without_a_reader(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), LABMOUSE_PROGRAM);
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  int ends[2];
  if (pipe(ends) != 0) return -1;
  close(ends[0]);
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    execv(words[0], words.data());
    _exit(127);
  }
  close(ends[1]);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// All that the program prints on a terminal of 80 columns and 24 rows; nothing where the system lends no terminals.
inline std::optional<std::string> on_a_terminal(std::vector<std::string> arguments, const char* variable) {
  arguments.insert(arguments.begin(), LABMOUSE_PROGRAM);
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  winsize window{};
  window.ws_row = 24;
  window.ws_col = 80;
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, &window);
  if (child < 0) return std::nullopt;
  if (child == 0) {
    putenv(const_cast<char*>(variable));
    execv(words[0], words.data());
    _exit(127);
  }
  std::string printed;
  char buffer[4096];
  // The read fails once the program has ended and all was read.
  for (ssize_t count; (count = read(terminal, buffer, sizeof buffer)) > 0;)
    printed.append(buffer, static_cast<std::size_t>(count));
  close(terminal);
  waitpid(child, nullptr, 0);
  return printed;
}

}  // namespace labmouse::test
