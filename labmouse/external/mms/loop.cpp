#include "labmouse/external/mms/loop.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/external/quoted_line.hpp"

namespace labmouse {
namespace {

/// A shorter repetition may be normal, such as a mouse that looks twice before it moves.
constexpr std::size_t least_rounds = 3, least_commands = 32;

/// Number of cells or commands of a loop shown in messages.
constexpr std::size_t most_shown = 8;

template <class Items, class Show>
std::string list_of(const Items& items, std::string_view between, Show show) {
  std::string text;
  for (std::size_t i = 0; i < std::min(items.size(), most_shown); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : between, show(items[i]));
  return text + (items.size() > most_shown ? fmt::format("{}...", between) : "");
}

std::string cell_text(Cell cell) { return fmt::format("({},{})", cell.x, cell.y); }

std::string round_text(const MmsLoop& loop) {
  const std::string count =
      loop.commands.size() == 1 ? "one command" : fmt::format("the same {} commands", loop.commands.size());
  if (loop.cells.size() == 1)
    return fmt::format("{} at {}: {}", count, cell_text(loop.cells.front()), list_of(loop.commands, ", ", quoted_line));
  return fmt::format("{} in the cells {}", count, list_of(loop.cells, " ", cell_text));
}

}  // namespace

void MmsTrail::add(std::string_view line, std::int64_t number, const HalfPose& pose) {
  if (steps_.size() < most) steps_.emplace_back();
  Step& step = steps_[next_];
  step.line = line;
  step.pose = pose;
  step.number = number;
  next_ = (next_ + 1) % most;
}

const MmsTrail::Step& MmsTrail::last(std::size_t back) const {
  return steps_[(next_ + steps_.size() - 1 - back) % steps_.size()];
}

std::optional<MmsLoop> MmsTrail::loop(std::int64_t lines) const {
  // Read backwards, a repetition at the end is a periodic prefix. border[i] is the length of the longest proper prefix
  // of the first i + 1 commands that is also their suffix (Knuth, Morris and Pratt); the prefix length minus its border
  // is its shortest period.
  std::vector<std::size_t> border(steps_.size());
  std::size_t length = 0, period = 0;
  for (std::size_t i = 1, common = 0; i < steps_.size(); ++i) {
    while (common > 0 && !same(last(i), last(common))) common = border[common - 1];
    if (same(last(i), last(common))) ++common;
    border[i] = common;
    if (i + 1 < std::max(least_commands, least_rounds * (i + 1 - common))) continue;
    length = i + 1;
    period = length - common;
  }
  if (length == 0) return std::nullopt;
  std::int64_t longest_gap = 0;
  for (std::size_t back = 0; back + 1 < length; ++back)
    longest_gap = std::max(longest_gap, last(back).number - last(back + 1).number);
  if (lines - last(0).number > longest_gap) return std::nullopt;
  MmsLoop loop{last(length - 1).number, length == most, {}, {}};
  for (std::size_t step = 0; step < period; ++step) {
    const Step& now = last(length - 1 - step);
    loop.commands.push_back(now.line);
    if (const Cell cell = cell_of(now.pose.place); loop.cells.empty() || loop.cells.back() != cell)
      loop.cells.push_back(cell);
  }
  if (loop.cells.size() > 1 && loop.cells.back() == loop.cells.front()) loop.cells.pop_back();
  return loop;
}

std::string loop_text(const MmsTrail& trail, std::int64_t lines) {
  const std::optional<MmsLoop> loop = trail.loop(lines);
  if (!loop) return fmt::format("no loop among its last {} commands", trail.size());
  return fmt::format("{} it repeats {}",
                     loop->began_earlier ? fmt::format("from line {} on at the latest", loop->first_line)
                                         : fmt::format("from line {} on", loop->first_line),
                     round_text(*loop));
}

}  // namespace labmouse
