#include "labmouse/lab/grading/grading_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

#include "labmouse/chance/rng.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

/// Collects the mazes of the tasks.
class Planning {
 public:
  Planning(TaskFile file, const std::string& path) : path_(path), folder_(fs::path(path).parent_path().string()) {
    plan_.file = std::move(file);
    plan_.files.push_back(path);
  }

  GradingPlan plan() && {
    set_world();
    if (plan_.world == nullptr) return std::move(plan_);
    for (const Task& task : plan_.file.tasks) {
      plan_.mazes_of.emplace_back();
      for (const std::string& named : task.mazes) add_files(task, named);
      for (int number = 0; number < task.hidden.count; ++number) add_hidden(task.hidden, number);
      if (task.hidden.count > 0 && plan_.file.seed.empty() && !lacks_seed_) {
        lacks_seed_ = true;
        fail(task, "hidden mazes need a secret seed; add seed = \"...\" at the top, or give --seed-file FILE");
      }
    }
    return std::move(plan_);
  }

 private:
  void fail(const Task& task, const std::string& reason) {
    plan_.errors.push_back(describe(path_, {task.line, task.column, fmt::format("task '{}': {}", task.name, reason)}));
  }

  void set_world() {
    WorldResult made = make_world(plan_.file.world, folder_);
    plan_.world = std::move(made.world);
    plan_.remarks = std::move(made.remarks);
    if (!made.error.empty()) plan_.errors.push_back(fmt::format("{}: {}", shown(path_), made.error));
  }

  void add_files(const Task& task, const std::string& named) {
    const std::string path = beside(folder_, named);
    MazeCollection found = load_mazes(std::vector{path});
    for (const SkippedFile& file : found.errors)
      for (const Problem& problem : file.problems)
        plan_.errors.push_back(fmt::format("{} (task '{}')", describe(file.path, problem), shown(task.name)));
    for (const SkippedFile& file : found.skipped)
      for (const Problem& problem : file.problems) plan_.remarks.push_back(describe(file.path, problem));
    for (const MazeNote& note : found.notes)
      plan_.remarks.push_back(fmt::format("{}: note: {}", shown(note.path), note.text));
    if (found.mazes.empty() && found.errors.empty()) fail(task, fmt::format("'{}' has no mazes", named));
    for (NamedMaze& maze : found.mazes) {
      plan_.files.push_back(maze.name);
      if (const std::string begin = folder_ + "/"; !folder_.empty() && maze.name.starts_with(begin))
        maze.name.erase(0, begin.size());
      const auto [place, is_new] = by_name_.try_emplace(maze.name, plan_.mazes.size());
      if (is_new) add(task, {std::move(maze), false});
      note_maze(place->second);
    }
  }

  void add(const Task& task, GradedMaze maze) {
    std::string reason = plan_.world->refuse(maze.maze.maze);
    if (reason.empty() && !plan_.world->facts(maze.maze.maze).bound) reason = "no mouse can score in this maze";
    if (!reason.empty()) fail(task, fmt::format("{}: {}", maze.maze.name, reason));
    plan_.mazes.push_back(std::move(maze));
  }

  /// Adds a hidden maze. Tasks with mazes of one kind share them, so that each mouse runs once in each.
  void add_hidden(const SecretMazes& hidden, int number) {
    const auto [place, is_new] = hidden_.try_emplace({hidden.kind, hidden.side, number}, plan_.mazes.size());
    if (is_new) {
      const std::string purpose = fmt::format("hidden {} {} {}", hidden.kind, hidden.side, number);
      plan_.mazes.push_back(
          {{fmt::format("hidden {}", hidden_.size()), secret_maze(hidden, plan_.file.seed, purpose)}, true});
    }
    note_maze(place->second);
  }

  void note_maze(std::size_t maze) {
    std::vector<std::size_t>& mazes = plan_.mazes_of.back();
    if (std::find(mazes.begin(), mazes.end(), maze) == mazes.end()) mazes.push_back(maze);
  }

  std::string path_, folder_;
  GradingPlan plan_;
  std::map<std::string, std::size_t> by_name_;
  std::map<std::tuple<std::string, int, int>, std::size_t> hidden_;
  bool lacks_seed_ = false;
};

}  // namespace

GradingPlan plan_grading(TaskFile file, const std::string& path) { return Planning(std::move(file), path).plan(); }

}  // namespace labmouse
