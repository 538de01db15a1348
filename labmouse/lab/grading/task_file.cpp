#include "labmouse/lab/grading/task_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "labmouse/lab/mice_files/limit_table.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/lab/text/toml_fields.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {
namespace {

constexpr auto file_keys =
    std::to_array<std::string_view>({"seed", "world", "settings", "runs", "limits", "show_hidden", "task"});
constexpr auto task_keys = std::to_array<std::string_view>(
    {"name", "points", "mazes", "hidden", "kind", "side", "finish", "at_most", "per_maze"});
constexpr int most_runs = 1'000'000;
constexpr double most_points = 1e6, largest_limit = 1e12;

/// The names under which tasks limit figures of a world.
std::vector<std::string_view> figures_of(const WorldTraits& world) {
  std::vector<std::string_view> names = {score_figure};
  if (world.has_ratio) names.push_back(ratio_figure);
  if (world.rules_in_steps) names.push_back(known_wall_hits_figure);
  constexpr auto others = std::to_array<std::string_view>({"maze", "seed", "outcome", said_last});
  for (const ContestField& field : world.fields->contest)
    if (!field.by_clock && std::find(others.begin(), others.end(), field.key) == others.end() &&
        std::find(names.begin(), names.end(), field.key) == names.end())
      names.push_back(field.key);
  return names;
}

/// Reads the entries of a task file, and collects its problems.
class TaskFileReader {
 public:
  TaskFileResult read(const toml::table& table) {
    fields_.refuse_unknown(table, file_keys);
    file_.seed = seed_of(table);
    file_.world = read_world(table, fields_);
    figures_ = figures_of(file_.world.entry->make({}).world->traits());
    file_.runs = fields_.whole(table, "runs", 1, most_runs);
    file_.limits = read_limits(table, fields_);
    file_.show_hidden = fields_.flag(table, "show_hidden");
    const toml::array* tasks = table["task"].as_array();
    if (tasks != nullptr && !tasks->empty() && tasks->is_homogeneous<toml::table>())
      for (const toml::node& task : *tasks) file_.tasks.push_back(task_of(*task.as_table()));
    else if (fields_.good())
      fields_.add({1, 1}, "has no tasks; each begins with a line [[task]]");
    if (!fields_.good()) return {{}, fields_.problems()};
    return {std::move(file_), {}};
  }

 private:
  std::string seed_of(const toml::table& table) {
    const toml::node* node = table.get("seed");
    if (node != nullptr && node->is_integer()) return fmt::format("{}", *node->value<std::int64_t>());
    return fields_.text(table, "seed");
  }

  Task task_of(const toml::table& table) {
    Task task;
    const auto place = table.source().begin;
    task.line = static_cast<int>(place.line);
    task.column = static_cast<int>(place.column);
    fields_.refuse_unknown(table, task_keys);
    task.name = fields_.text(table, "name");
    if (!table.contains("name"))
      fields_.add(place, "this task has no name; add name = \"...\"");
    else if (!task.name.empty() && !names_.insert(task.name).second)
      fields_.add(table.get("name")->source().begin,
                  fmt::format("the name '{}' stands twice; give each task its own", task.name));
    task.points = fields_.number(table, "points", 0.0, most_points).value_or(0.0);
    if (!table.contains("points")) fields_.add(place, "this task has no points; add points = 5");
    read_mazes(table, task);
    task.finish = fields_.flag(table, "finish");
    task.at_most = limits_of(table);
    task.per_maze = fields_.flag(table, "per_maze");
    if (!task.finish && !table.contains("at_most"))
      fields_.add(place, "this task requires nothing; add finish = true or at_most = { ratio = 1.3 }");
    return task;
  }

  void read_mazes(const toml::table& table, Task& task) {
    task.mazes = fields_.texts(table, "mazes", "[\"capstone-1\", \"mazes/\"]");
    const auto is_bad = [](const std::string& path) { return path.empty() || shown(path) != path; };
    if (std::any_of(task.mazes.begin(), task.mazes.end(), is_bad))
      fields_.add(table.get("mazes")->source().begin, "the name of a maze must be printable and not empty");
    task.hidden.count = fields_.whole(table, "hidden", 1, most_secret_mazes).value_or(0);
    if (!table.contains("hidden")) {
      for (const std::string_view key : {"kind", "side"})
        if (const toml::node* node = table.get(key))
          fields_.add(node->source().begin,
                      fmt::format("'{}' applies to hidden mazes only; add hidden = 20, or remove it", key));
      if (const toml::array* list = table["mazes"].as_array();
          list != nullptr ? list->empty() : !table.contains("mazes"))
        fields_.add(table.source().begin, "this task has no mazes; add mazes = [\"capstone-1\"] or hidden = 20");
    }
    if (table.contains("kind")) task.hidden.kind = fields_.text(table, "kind");
    task.hidden.side = fields_.whole(table, "side", 1, max_side).value_or(task.hidden.side);
    if (task.hidden.count > 0) check_hidden(table, task.hidden);
  }

  void check_hidden(const toml::table& table, const SecretMazes& hidden) {
    if (hidden.kind.empty()) return;  // another problem
    const std::string reason = refuse(hidden);
    const bool is_kind = table.contains("kind") && find_generator(hidden.kind) == nullptr;
    const std::string_view key = is_kind ? "kind" : table.contains("side") ? "side" : "hidden";
    if (!reason.empty()) fields_.add(table.get(key)->source().begin, reason);
  }

  std::vector<FigureLimit> limits_of(const toml::table& table) {
    const toml::node* node = table.get("at_most");
    if (node == nullptr) return {};
    const toml::table* limits = node->as_table();
    if (limits == nullptr || limits->empty()) {
      fields_.add(node->source().begin, "'at_most' must be a table of figures, such as { ratio = 1.3 }");
      return {};
    }
    fields_.refuse_unknown(*limits, figures_);
    std::vector<FigureLimit> all;
    for (const std::string_view figure : figures_)
      if (const auto most = fields_.number(*limits, figure, -largest_limit, largest_limit))
        all.push_back({std::string(figure), *most});
    return all;
  }

  std::set<std::string> names_;
  std::vector<std::string_view> figures_;
  TaskFile file_;
  TomlFields fields_;
};

}  // namespace

TaskFileResult read_task_file(std::string_view text) {
  const TomlText toml = parse_toml(text);
  if (!toml.problems.empty()) return {{}, toml.problems};
  return TaskFileReader().read(toml.table);
}

}  // namespace labmouse
