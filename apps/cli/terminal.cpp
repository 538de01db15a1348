#include "terminal.hpp"

#include <array>
#include <csignal>

#ifdef _WIN32  // not tried
#include <io.h>
#else
#include <sys/ioctl.h>
#include <unistd.h>
#endif

namespace labmouse::cli {

#ifdef _WIN32

namespace {
constexpr std::array endings = {SIGTERM, SIGINT};
}  // namespace

bool is_terminal(std::FILE* stream) { return _isatty(_fileno(stream)) != 0; }
std::optional<TerminalSize> terminal_size() { return std::nullopt; }
bool is_hangup(int) { return false; }
void let_writes_fail() {}

#else

namespace {
constexpr std::array endings = {SIGHUP, SIGTERM, SIGINT};
}  // namespace

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) != 0; }

std::optional<TerminalSize> terminal_size() {
  winsize window{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_row == 0) return std::nullopt;
  return TerminalSize{window.ws_col, window.ws_row};
}

bool is_hangup(int signal) { return signal == SIGHUP; }

void let_writes_fail() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

#endif

std::span<const int> ending_signals() { return endings; }

}  // namespace labmouse::cli
