#include "frames.hpp"

#include <fmt/format.h>

#include "command.hpp"
#include "terminal.hpp"

namespace labmouse::cli {
namespace {

/// Terminal codes that print the text from the top of the screen and erase the rest of each line and of the screen.
std::string over_the_last(std::string_view text) {
  std::string frame = "\x1b[H";
  for (const char letter : text) frame += letter == '\n' ? std::string("\x1b[K\n") : std::string(1, letter);
  return frame + "\x1b[J";
}

/// Throws UsageError where a frame would scroll or wrap.
void require_room(Size size, int lines) {
  const auto window = terminal_size();
  const int columns = 4 * size.width + 4, rows = 2 * size.height + 3 + lines;
  if (!window || (window->columns >= columns && window->rows >= rows)) return;
  throw UsageError(
      fmt::format("error: watching a {}x{} maze needs a terminal of {}x{}, but this one is {}x{}; enlarge the window, "
                  "use a smaller font, or pipe the output into a pager",
                  size.width, size.height, columns, rows, window->columns, window->rows));
}

}  // namespace

Frames::Frames(Size size, int lines) : moving_(is_terminal(stdout)) {
  if (!moving_) return;
  require_room(size, lines);
  print("\x1b[2J");
}

void Frames::show(const std::string& frame) const { print(moving_ ? over_the_last(frame) : frame); }

}  // namespace labmouse::cli
