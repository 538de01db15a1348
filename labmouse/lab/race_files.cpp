#include "labmouse/lab/race_files.hpp"

#include <fmt/format.h>

#include <memory>

#include "labmouse/lab/files.hpp"

namespace labmouse {
namespace {

/// A name as one part of a path: what could lead elsewhere or trouble a shell becomes `_`.
std::string file_name(const std::string& name) {
  std::string safe;
  for (const char letter : name) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                       (letter >= '0' && letter <= '9') || letter == '-' || letter == '_' || letter == '.' || letter == '=';
    safe += plain ? letter : '_';
  }
  while (safe.starts_with('.')) safe.erase(0, 1);
  return safe.empty() ? "_" : safe;
}

std::string save(const std::string& path, const std::string& content) {
  const auto error = write_file(path, content);
  return error.empty() ? "" : fmt::format("{}: error: {}", path, error);
}

}  // namespace

RecordFile record_file_of(const Contestant& mouse, const NamedMaze& maze, const Rules& rules, std::uint64_t seed,
                          const RunRecord& record) {
  RecordFile file;
  file.maze_name = maze.name;
  file.maze = maze.maze;
  file.mouse = mouse.name;
  file.settings = mouse.settings;
  file.seed = seed;
  file.rules = rules;
  file.run = record;
  return file;
}

std::string title_of(const RecordFile& file) {
  const Score result = score(file.run, file.rules);
  return fmt::format("{} in {}: {}", file.mouse, file.maze_name,
                     result.value ? fmt::format("score {:.3f}", *result.value) : std::string(name_of(result.outcome)));
}

DrawingLayers layers_of(const Maze& maze, const RunRecord& record) {
  DrawingLayers layers;
  layers.coordinates = true;
  const auto visits = std::make_shared<std::vector<int>>(static_cast<std::size_t>(maze.size().area()));
  for (const StepRecord& step : record.steps) {
    if (step.run == Run::speed)
      layers.route.push_back(step.pose);
    else
      ++(*visits)[static_cast<std::size_t>(maze.size().index(step.pose.cell))];
  }
  if (!layers.route.empty()) layers.route.push_back(record.end);
  layers.visits = [visits, size = maze.size()](Cell cell) { return (*visits)[static_cast<std::size_t>(size.index(cell))]; };
  return layers;
}

std::string save_contest(const std::string& folder, const Race& race, const ContestResult& contest,
                         const RunRecord& record) {
  const Contestant& mouse = race.mice[contest.mouse];
  const NamedMaze& maze = race.mazes[contest.maze];
  const std::string path = fmt::format("{}/{}/{}", folder, file_name(mouse.name), file_name(maze.name));
  const RecordFile file = record_file_of(mouse, maze, race.order.rules, contest.seed, record);
  if (auto error = save(fmt::format("{}-{}.jsonl", path, contest.run + 1), write_record(file)); !error.empty()) return error;
  if (contest.run > 0) return "";
  DrawingLayers layers = layers_of(maze.maze, record);
  layers.title = title_of(file);
  return save(path + ".svg", draw_svg(maze.maze, layers));
}

}  // namespace labmouse
