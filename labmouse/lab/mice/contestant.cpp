#include "labmouse/lab/mice/contestant.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/mice/maze_holders.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {

bool Contestant::walks() const {
  const auto* decider = std::get_if<Decider>(&kind);
  return decider != nullptr ? decider->make != nullptr : std::holds_alternative<PlayedContests>(kind);
}

bool Contestant::drives() const {
  if (const auto* program = std::get_if<MmsProgram>(&kind)) return program->drive != nullptr;
  const auto* decider = std::get_if<Decider>(&kind);
  return decider != nullptr && decider->drive != nullptr;
}

std::unique_ptr<Strategy> Contestant::strategy(const Maze& maze, const Briefing& briefing) const {
  return std::get<Decider>(kind).make(maze, briefing);
}

std::unique_ptr<DrivingStrategy> Contestant::driving_strategy(const Maze& maze, const Briefing& briefing) const {
  if (const auto* program = std::get_if<MmsProgram>(&kind)) return program->drive(briefing);
  return std::get<Decider>(kind).drive(maze, briefing);
}

std::string freedom_note(const std::vector<Contestant>& mice) {
  const auto find = [&](const auto& holds) { return std::find_if(mice.begin(), mice.end(), holds); };
  std::string note;
  if (const auto free = find([](const Contestant& mouse) { return mouse.sandboxed == false; }); free != mice.end())
    note += fmt::format(
        "External mice ran without a sandbox{}: they could do whatever you can.\n"
        "Not protected against reading mazes, nor against remembering earlier contests.\n",
        free->why_no_sandbox.empty() ? ""
                                     : fmt::format(", which this system does not offer ({})", free->why_no_sandbox));
  const auto hides = [](const Contestant& mouse) { return mouse.sandboxed == true && mouse.hidden != nullptr; };
  if (const auto hidden = find(hides); hidden != mice.end())
    for (const std::string& folder : hidden->hidden->unsearched())
      note += fmt::format(
          "Not protected against reading mazes in {}: of its files only {} were searched for mazes to hide.\n",
          shown(folder), most_searched);
  const auto keeps = [](const Contestant& mouse) { return mouse.sandboxed == true && mouse.keeps_folder; };
  if (find(keeps) != mice.end())
    note += "External mice kept their folders (--keep-folder): they may remember earlier contests.\n";
  const auto reads = [](const Contestant& mouse) { return mouse.reads_only; };
  if (find(reads) != mice.end())
    note +=
        "The folders of external mice were read-only, because this system has no overlays; they could write to /tmp.\n";
  return note;
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
