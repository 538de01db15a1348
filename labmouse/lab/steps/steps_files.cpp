#include "labmouse/lab/steps/steps_files.hpp"

#include <fmt/format.h>

#include "labmouse/contest/coverage.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/mice/mouse_names.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/pictures/picture_layers.hpp"
#include "labmouse/lab/system/file_names.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/last_lines.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

/// The reason of a forfeit in brackets, or nothing.
std::string reason_in_brackets(const RunRecord& run) {
  if (run.outcome != Outcome::forfeit || run.steps.empty()) return "";
  return fmt::format(" ({})", name_of(run.steps.back().action.reason));
}

}  // namespace

Held kept(const Contestant& mouse, const NamedMaze& maze, const Rules& rules, std::uint64_t seed, RunRecord record,
          Keep keep) {
  Held held;
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

std::string title_of(const RecordFile& file) {
  const Score result = score(file.run, file.rules);
  const std::string where = fmt::format("{} in {}: ", mouse_names({file.mouse}).front(), stem_of(file.maze_name));
  if (result.value) return where + fmt::format("score {:.3f}", *result.value);
  if (!file.ended) return where + fmt::format("breaks off after step {}", file.run.steps.size());
  return where + std::string(name_of(result.outcome));
}

std::string picture_of(const RecordFile& file) {
  DrawingLayers layers = layers_of(file, contest_layers());
  layers.title = title_of(file);
  return draw_svg(*file.maze, layers);
}

std::string exploration_line(const RecordFile& file) {
  const Coverage coverage = coverage_of(file.run, *file.maze);
  const int cells = reachable_cells(*file.maze).count();
  return fmt::format("exploration: discovered {:.1f} %, visited {:.1f} % of {} reachable {}",
                     100.0 * coverage.discovered, 100.0 * coverage.visited, cells, cells == 1 ? "cell" : "cells");
}

std::string result_line(const RecordFile& file) {
  const Score result = score(file.run, file.rules);
  const Bound bound = bound_of(*file.maze, file.rules);
  std::string line = fmt::format("{} in {}: ", file.mouse, file.maze_name);
  if (!file.ended && !result.value)
    line += fmt::format("the record breaks off after step {}", file.run.steps.size());
  else if (result.value)
    line += fmt::format("solved, score {:.3f} = {} speed + {} exploration / {}", *result.value, result.speed_steps,
                        result.exploration_steps, file.rules.exploration_factor);
  else
    line += fmt::format("{}{} at ({},{}) heading {} after {} exploration and {} speed steps", name_of(result.outcome),
                        reason_in_brackets(file.run), file.run.end.cell.x, file.run.end.cell.y,
                        name_of(file.run.end.heading), result.exploration_steps, result.speed_steps);
  line += bound.score ? fmt::format("; bound {:.3f}", *bound.score) : "; the goal cannot be reached";
  return shown(line);
}

std::string checked_line(const RecordFile& file) {
  const auto whole = [](const GivenFields& given) { return given == GivenFields(); };
  const bool whole_end = !file.ended || (file.given_end.cell && file.given_end.heading);
  if (whole_end && std::all_of(file.given.begin(), file.given.end(), whole)) return "";
  const auto checked = [&](bool GivenFields::*field, std::string_view one, std::string_view many) {
    const auto has = [&](const GivenFields& given) { return given.*field; };
    const auto count = static_cast<int>(std::count_if(file.given.begin(), file.given.end(), has));
    return count > 0 ? ", " + counted(count, one, many) : "";
  };
  const std::string readings = checked(&GivenFields::reading, "reading", "readings");
  std::string line = fmt::format("checked in {}: ", counted(static_cast<int>(file.given.size()), "step", "steps"));
  line += readings.empty() ? "no readings" : readings.substr(2);
  line += checked(&GivenFields::cell, "cell", "cells") + checked(&GivenFields::heading, "heading", "headings");
  line += checked(&GivenFields::run, "run", "runs") + checked(&GivenFields::blocked, "blocked flag", "blocked flags");
  return line + (file.ended ? ", the outcome" : "");
}

std::string last_words_lines(const RecordFile& file) {
  constexpr std::size_t most = 10;
  std::string_view words = file.run.last_words;
  std::string text;
  if (file.run.outcome == Outcome::forfeit && !words.empty()) {
    const auto end = std::min(words.find('\n'), words.size());
    text = shown(words.substr(0, end)) + "\n";
    words.remove_prefix(end);
  }
  for (const std::string& line : last_lines(words, most)) text += fmt::format("| {}\n", shown(line));
  return text;
}

std::string counts_line(const RecordFile& file) {
  std::string line;
  for (const Count& count : file.run.counts)
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count.name, count.value);
  return shown(line);
}

}  // namespace labmouse
