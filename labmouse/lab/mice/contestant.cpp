#include "labmouse/lab/mice/contestant.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace labmouse {

std::string freedom_note(const std::vector<Contestant>& mice) {
  const auto free =
      std::find_if(mice.begin(), mice.end(), [](const Contestant& mouse) { return mouse.sandboxed == false; });
  if (free == mice.end()) return "";
  return fmt::format(
      "Guests ran without a sandbox{}: they could do whatever you can.\n",
      free->why_no_sandbox.empty() ? "" : fmt::format(", which this system does not offer ({})", free->why_no_sandbox));
}

void rename(Contestant& mouse, const std::string& name) {
  mouse.spec = spec_of(mouse);
  mouse.name = name;
  if (!mouse.taught) return;
  mouse.taught = [teach = mouse.taught, name](const std::vector<const Maze*>& training, const Rules& rules,
                                              const std::atomic<bool>* stop) {
    Contestant pupil = teach(training, rules, stop);
    rename(pupil, name);
    return pupil;
  };
}

}  // namespace labmouse
