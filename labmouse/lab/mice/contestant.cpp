#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse {

void rename(Contestant& mouse, const std::string& name) {
  mouse.spec = spec_of(mouse);
  mouse.name = name;
  if (!mouse.taught) return;
  mouse.taught = [teach = mouse.taught, name](const std::vector<const Maze*>& training, const Rules& rules) {
    Contestant pupil = teach(training, rules);
    rename(pupil, name);
    return pupil;
  };
}

}  // namespace labmouse
