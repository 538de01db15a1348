#include "labmouse/lab/steps/steps_files.hpp"

#include <fmt/format.h>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/replays/steps_text.hpp"

namespace labmouse {

ContestOutput kept(const Contestant& mouse, const NamedMaze& maze, const Rules& rules, std::uint64_t seed,
                   RunRecord record, Keep keep) {
  ContestOutput held;
  if (keep.record || keep.picture) {
    const RecordFile file = record_file_of(mouse, maze, rules, seed, record);
    if (keep.record) held.record = write_record(file);
    if (keep.picture) held.picture = picture_of(file);
  }
  held.run = std::move(record);
  return held;
}

RecordFile record_file_of(const Contestant& mouse, const NamedMaze& maze, const Rules& rules, std::uint64_t seed,
                          const RunRecord& record) {
  RecordFile file;
  file.maze_name = maze.name;
  file.maze = maze.maze;
  file.mouse = mouse.name;
  file.spec = mouse.spec;
  file.settings = settings_in_steps(mouse);
  if (mouse.interpreter)
    file.interpreter = fmt::format("{}{}{}", mouse.interpreter->path, mouse.interpreter->version.empty() ? "" : " ",
                                   mouse.interpreter->version);
  file.seed = seed;
  file.rules = rules;
  file.run = record;
  return file;
}

}  // namespace labmouse
