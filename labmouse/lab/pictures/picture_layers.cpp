#include "labmouse/lab/pictures/picture_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "labmouse/contest/coverage.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/text/commas.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {
namespace {

struct LayerLine {
  std::string_view name;
  std::string_view meaning;
  bool of_a_record = false;
};

constexpr std::array<LayerLine, 10> lines = {{
    {.name = "heat", .meaning = "how often the search run entered each cell", .of_a_record = true},
    {.name = "path", .meaning = "the speed run with its steps numbered; for a maze alone, a shortest run"},
    {.name = "search",
     .meaning = "the path of the search run: to the goal, and from there to the reset",
     .of_a_record = true},
    {.name = "known",
     .meaning = "walls still unknown at the end of the search run, drawn faintly",
     .of_a_record = true},
    {.name = "wrong",
     .meaning = "those of them that are closed, though an optimist assumes they are open",
     .of_a_record = true},
    {.name = "shares", .meaning = "the cells visited and discovered, and their shares", .of_a_record = true},
    {.name = "distances", .meaning = "steps from each cell to the goal"},
    {.name = "cells", .meaning = "cells to walk from each cell to the goal"},
    {.name = "coordinates", .meaning = "the numbers of columns and rows"},
    {.name = "candidates",
     .meaning = "the unseen walls it last chose from, if the record has reasons",
     .of_a_record = true},
}};

const LayerLine& line_of(Layer layer) { return lines[static_cast<std::size_t>(layer)]; }

std::string unknown_name(std::string_view name) {
  std::vector<std::string_view> names;
  for (const LayerLine& line : lines) names.push_back(line.name);
  const auto near = nearest_name(name, names);
  return fmt::format("unknown layer '{}'; {}", name,
                     near.empty() ? fmt::format("the layers are {}", fmt::join(names, ", "))
                                  : fmt::format("did you mean '{}'?", near));
}

void add_labels(const Maze& maze, const Motion& motion, std::string meaning, DrawingLayers& layers) {
  const auto field = std::make_shared<DistanceField>(maze.size(), motion);
  field->fill(maze.open_walls(), maze.goals());
  layers.label = [field](Cell cell) {
    return field->reaches(cell) ? fmt::format("{}", field->at(cell)) : std::string();
  };
  layers.label_meaning = std::move(meaning);
}

/// The layers that need no record and mean the same with one.
DrawingLayers ground_of(const Maze& maze, const Rules& rules, const LayerSet& chosen) {
  DrawingLayers layers;
  layers.coordinates = chosen.contains(Layer::coordinates);
  if (chosen.contains(Layer::distances)) add_labels(maze, strides(rules.stride), "steps to the goal", layers);
  if (chosen.contains(Layer::cells)) add_labels(maze, strides(1), "cells to the goal", layers);
  return layers;
}

std::function<int(Cell)> visits_of(Size size, const RunRecord& record) {
  const auto visits = std::make_shared<std::vector<int>>(static_cast<std::size_t>(size.area()));
  for (const Cell cell : explored_way(record, size)) ++(*visits)[static_cast<std::size_t>(size.index(cell))];
  return [visits, size](Cell cell) { return (*visits)[static_cast<std::size_t>(size.index(cell))]; };
}

std::vector<Pose> speed_run(const RunRecord& record) {
  std::vector<Pose> poses;
  for (const StepRecord& step : record.steps)
    if (step.run == Run::speed) poses.push_back(step.pose);
  if (!poses.empty()) poses.push_back(record.end);
  return poses;
}

std::vector<Pose> shortest_route(const Maze& maze, const Rules& rules) {
  std::vector<Pose> poses = {{maze.start(), maze.start_heading()}};
  for (const Action& action : shortest_run(maze, rules)) poses.push_back(after(poses.back(), action));
  return poses;
}

SearchLegs search_run_of(const Maze& maze, const RunRecord& record) {
  SearchLegs legs;
  for (std::size_t i = 0; i < record.steps.size() && record.steps[i].run == Run::search_run; ++i) {
    const StepRecord& step = record.steps[i];
    if (i == 0) legs.to_goal.push_back(step.pose);
    if (step.action.kind != Action::Kind::step) continue;
    const Pose next = i + 1 < record.steps.size() ? record.steps[i + 1].pose : record.end;
    const bool after_goal = !legs.onwards.empty();
    (after_goal ? legs.onwards : legs.to_goal).push_back(next);
    if (!after_goal && maze.is_goal(next.cell)) legs.onwards.push_back(next);
  }
  return legs;
}

/// The walls that the search run has not seen.
WallSet unknown_walls(const Maze& maze, const RunRecord& record) {
  Knowledge knowledge(maze.size());
  for (const StepRecord& step : record.steps) {
    if (step.run != Run::search_run) break;
    // A record that agrees with its maze has no contradicting readings.
    [[maybe_unused]] const bool learned = knowledge.learn(step.pose, step.sighting);
  }
  return knowledge.unknown();
}

}  // namespace

std::string_view name_of(Layer layer) { return line_of(layer).name; }
std::string_view meaning_of(Layer layer) { return line_of(layer).meaning; }

const LayerSet& all_layers() {
  static const LayerSet all = {Layer::heat,        Layer::path,      Layer::search_run, Layer::known,
                               Layer::wrong,       Layer::shares,    Layer::distances,  Layer::cells,
                               Layer::coordinates, Layer::candidates};
  return all;
}

bool needs_record(Layer layer) { return line_of(layer).of_a_record; }
bool needs_svg(Layer layer, bool colours) {
  return layer == Layer::shares || layer == Layer::candidates || (layer == Layer::heat && !colours);
}

LayersResult read_layers(std::string_view names) {
  LayersResult result;
  for (const std::string& name : between_commas(names)) {
    const auto line =
        std::find_if(lines.begin(), lines.end(), [&](const LayerLine& each) { return each.name == today_value(name); });
    if (line == lines.end()) return {{}, unknown_name(name)};
    result.layers.insert(static_cast<Layer>(line - lines.begin()));
  }
  if (result.layers.contains(Layer::distances) && result.layers.contains(Layer::cells))
    return {{}, "the layers distances and cells write in the same places; choose one"};
  return result;
}

DrawingLayers layers_of(const Maze& maze, const Rules& rules, const LayerSet& chosen) {
  DrawingLayers layers = ground_of(maze, rules, chosen);
  if (chosen.contains(Layer::path)) layers.route = shortest_route(maze, rules);
  return layers;
}

DrawingLayers layers_of(const RecordFile& file, const LayerSet& chosen) {
  const Maze& maze = *file.maze;
  DrawingLayers layers = ground_of(maze, file.rules, chosen);
  if (chosen.contains(Layer::heat)) layers.visits = visits_of(maze.size(), file.run);
  if (chosen.contains(Layer::path)) layers.route = speed_run(file.run);
  if (chosen.contains(Layer::search_run)) layers.search_run = search_run_of(maze, file.run);
  if (chosen.contains(Layer::known)) layers.unknown = unknown_walls(maze, file.run);
  if (chosen.contains(Layer::wrong)) {
    layers.wrong = unknown_walls(maze, file.run);
    *layers.wrong -= maze.open_walls();
  }
  if (chosen.contains(Layer::shares)) layers.explored = explored_cells(file.run, maze);
  if (chosen.contains(Layer::candidates) && !file.run.reasons.empty()) {
    layers.candidates = file.run.reasons.back();
    layers.mouse = file.run.steps[static_cast<std::size_t>(layers.candidates->step) - 1].pose;
  }
  return layers;
}

RecordFile as_of(RecordFile file, int step) {
  RunRecord& run = file.run;
  const auto count = static_cast<std::size_t>(step);
  if (count >= run.steps.size()) return file;
  run.end = run.steps[count].pose;
  run.steps.resize(count);
  run.outcome = Outcome::out_of_steps;
  run.counts.clear();
  std::erase_if(run.reasons, [&](const StepReasons& reasons) { return reasons.step > step; });
  file.ended = false;
  return file;
}

const LayerSet& contest_layers() {
  static const LayerSet layers = {Layer::heat, Layer::path, Layer::coordinates};
  return layers;
}

}  // namespace labmouse
