#include "labmouse/lab/live/live_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace labmouse {
namespace {

using Found = LiveFinding::Kind;

std::string place_of(Cell cell) { return fmt::format("({},{})", cell.x, cell.y); }

std::string origin_of(const WallReading& reading) {
  return reading.is_drawn ? std::string("drawn by the robot") : "seen from " + place_of(reading.cell);
}

std::string wall_of(const WallReading& reading) {
  return fmt::format("the wall {} of {}", name_of(reading.side), place_of(reading.cell));
}

const char* state_of(bool closed) { return closed ? "closed" : "open"; }

Found kind_of_wrong(const WallReading& reading) { return reading.closed ? Found::false_wall : Found::missed_wall; }

/// Whether one cannot come from the one cell to the other within a move.
bool are_apart(Cell one, Cell other) { return std::abs(one.x - other.x) + std::abs(one.y - other.y) > 1; }

}  // namespace

std::string words_of(const LiveFinding& finding) {
  const std::string line = fmt::format("line {}: ", finding.line);
  switch (finding.kind) {
    case Found::restart:
      return line + "restart" + (finding.cell ? " in " + place_of(*finding.cell) : "");
    case Found::outside:
      return line + "cell " + place_of(*finding.cell) + " lies outside of the maze";
    case Found::open_border:
      return line + wall_of(*finding.now) + " is open, but it is the border";
    case Found::contradiction:
      return line + fmt::format("{} is {}, but {} in line {}, {}", wall_of(*finding.now), state_of(finding.now->closed),
                                state_of(finding.before->closed), finding.before->line, origin_of(*finding.before));
    case Found::false_wall:
      return line + "false wall: " + wall_of(*finding.now) + " is closed, but open in the maze";
    case Found::missed_wall:
      break;
  }
  return line + "missed wall: " + wall_of(*finding.now) + " is open, but closed in the maze";
}

LiveMap::LiveMap(Size size) : size_(size) {}

LiveMap::LiveMap(const Maze& truth) : size_(truth.size()), truth_(truth), start_(truth.start()) {}

std::vector<LiveFinding> LiveMap::add(const LiveLine& line) {
  std::vector<LiveFinding> findings;
  if (line.is_restart) add_restart(line, findings);
  if (line.seen) add_cell(line, *line.seen, findings);
  if (line.drawing) add_drawing(*line.drawing, line.number, findings);
  for (const LiveField& field : line.fields)
    if (fields_.contains(field.name) || fields_.size() < most_fields) fields_[field.name] = field.value;
  // A route begins where the robot was when it planned it.
  if (line.seen && std::none_of(line.fields.begin(), line.fields.end(),
                                [](const LiveField& field) { return field.name == "route"; }))
    fields_.erase("route");
  return findings;
}

void LiveMap::add_restart(const LiveLine& line, std::vector<LiveFinding>& findings) {
  ++restarts_;
  pose_.reset();
  fields_.clear();
  findings.push_back({.kind = Found::restart, .line = line.number});
}

void LiveMap::add_cell(const LiveLine& line, const SeenCell& seen, std::vector<LiveFinding>& findings) {
  const Cell cell = seen.pose.cell;
  if (!size_.contains(cell)) {
    findings.push_back({.kind = Found::outside, .line = line.number, .cell = cell});
    return;
  }
  if (cell == start_ && pose_ && are_apart(pose_->cell, cell)) {
    add_restart(line, findings);
    findings.back().cell = cell;
  }
  pose_ = seen.pose;
  cells_.insert(cell);
  for (const Heading side : all_headings)
    if (const std::optional<bool> closed = seen.closed[static_cast<std::size_t>(side)])
      add_wall({cell, side, *closed, line.number}, findings);
}

void LiveMap::add_drawing(const PartialMap& drawing, std::int64_t line, std::vector<LiveFinding>& findings) {
  if (drawing.known.size() != size_) return;
  WallSet seen = WallSet::all(size_);
  seen -= drawing.unseen;
  seen.for_each([&](Wall wall) {
    add_wall({wall.cell, wall.side, !drawing.known.is_open(wall.cell, wall.side), line, true}, findings);
  });
}

void LiveMap::add_wall(const WallReading& reading, std::vector<LiveFinding>& findings) {
  const Wall wall = wall_at(reading.cell, reading.side);
  LiveFinding finding{.line = reading.line, .cell = reading.cell, .now = reading};
  if (on_border(wall, size_)) {
    finding.kind = Found::open_border;
    if (!reading.closed) findings.push_back(finding);
    return;
  }
  const auto [known, is_new] = walls_.try_emplace(wall, Readings{reading, {}});
  const bool changes = !is_new && known->second.newest.closed != reading.closed;
  if (changes) {
    known->second.contradicting = known->second.newest;
    finding.kind = Found::contradiction;
    finding.before = known->second.newest;
    findings.push_back(finding);
    finding.before.reset();
  }
  known->second.newest = reading;
  if (!(is_new || changes) || !is_wrong(reading)) return;
  finding.kind = kind_of_wrong(reading);
  findings.push_back(finding);
}

bool LiveMap::is_wrong(const WallReading& reading) const {
  return truth_ && truth_->is_open(reading.cell, reading.side) == reading.closed;
}

PartialMap LiveMap::map() const {
  MazeDraft draft(size_, MazeDraft::Inside::open);
  WallSet unseen = WallSet::all(size_);
  for (const auto& [wall, readings] : walls_) {
    unseen.erase(wall);
    if (readings.newest.closed) draft.close(wall.cell, wall.side);
  }
  const Maze known(draft);
  if (!truth_) return {known, unseen};
  return {known.with_start(truth_->start(), truth_->start_heading()).with_goals(truth_->goals()), unseen};
}

std::vector<LiveFinding> LiveMap::contradictions() const {
  std::vector<LiveFinding> all;
  for (const auto& [wall, readings] : walls_)
    if (readings.contradicting)
      all.push_back({.kind = Found::contradiction,
                     .line = readings.newest.line,
                     .cell = readings.newest.cell,
                     .now = readings.newest,
                     .before = readings.contradicting});
  return all;
}

std::vector<LiveFinding> LiveMap::wrong_walls() const {
  std::vector<LiveFinding> all;
  for (const auto& [wall, readings] : walls_)
    if (is_wrong(readings.newest))
      all.push_back({.kind = kind_of_wrong(readings.newest),
                     .line = readings.newest.line,
                     .cell = readings.newest.cell,
                     .now = readings.newest});
  return all;
}

std::vector<Pose> LiveMap::route() const {
  const auto field = fields_.find("route");
  if (!pose_ || field == fields_.end()) return {};
  std::vector<Pose> poses = {*pose_};
  for (const char letter : field->second) {
    const auto index = std::string_view("NESW").find(letter);
    if (index == std::string_view::npos) break;
    const auto heading = static_cast<Heading>(index);
    const Cell next = neighbour(poses.back().cell, heading);
    if (!size_.contains(next)) break;
    // A straight is one step, as in drawings of runs.
    if (poses.size() > 1 && poses.back().heading == heading)
      poses.back().cell = next;
    else
      poses.push_back({next, heading});
  }
  if (poses.size() == 1) poses.clear();
  return poses;
}

}  // namespace labmouse
