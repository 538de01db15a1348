#include "labmouse/external/protocol.hpp"

#include <fmt/format.h>

#include "labmouse/functions/parse_number.hpp"

namespace labmouse {
namespace {

/// Invalid rotations and movements are allowed in a contest, up to what a record can hold.
constexpr int farthest = 1'000'000;

/// Removes one blank and a whole number from the front of the text; false if there is none.
bool take_number(std::string_view& text, int& number) {
  if (!text.starts_with(' ')) return false;
  text.remove_prefix(1);
  number = take_whole<int>(text).value_or(farthest + 1);
  return number >= -farthest && number <= farthest;
}

}  // namespace

std::string briefing_text(const Briefing& briefing) {
  std::string text =
      fmt::format("{}\nsize {} {}\nstart {} {} {}\n", program_greeting, briefing.size.width, briefing.size.height,
                  briefing.start.cell.x, briefing.start.cell.y, name_of(briefing.start.heading));
  briefing.goals.for_each([&](Cell goal) { text += fmt::format("goal {} {}\n", goal.x, goal.y); });
  return text +
         fmt::format("stride {}\nbudget {}\nseed {}\nbegin\n", briefing.motion.longest, briefing.budget, briefing.seed);
}

std::string question(const Sighting& seen) {
  return fmt::format("sense {} {} {}\n", seen.left, seen.ahead, seen.right);
}

std::optional<Action> read_answer(std::string_view line) {
  constexpr std::string_view move = "move";
  if (line == "reset") return Action::reset();
  if (line == "forfeit") return Action::forfeit(ForfeitReason::gave_up);
  if (!line.starts_with(move)) return std::nullopt;
  line.remove_prefix(move.size());
  int rotation = 0, movement = 0;
  if (!take_number(line, rotation) || !take_number(line, movement) || !line.empty()) return std::nullopt;
  return Action::step(rotation, movement);
}

}  // namespace labmouse
