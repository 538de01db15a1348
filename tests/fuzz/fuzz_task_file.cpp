// Any bytes as a task file: there are tasks with names of their own, mazes and something that they require, or there
// are problems.
#include <set>

#include "labmouse/lab/grading/task_file.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(task_file) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const TaskFileResult read = read_task_file(text);
  require(read.file.tasks.empty() != read.problems.empty());
  require(read.problems.size() <= most_problems);
  std::set<std::string> names;
  for (const Task& task : read.file.tasks) {
    require(!task.name.empty() && names.insert(task.name).second);
    require(task.points >= 0.0 && task.line > 0);
    require(!task.mazes.empty() || task.hidden.count > 0);
    require(task.finish || !task.at_most.empty());
    const GeneratorOrder order = {{task.hidden.side, task.hidden.side}, 1, 0};
    if (task.hidden.count > 0) require(find_generator(task.hidden.kind)->refuses(order).empty());
  }
  if (read.problems.empty()) require(read.file.world.entry != nullptr);
  return 0;
}

}  // namespace labmouse::fuzz
