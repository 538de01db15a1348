#include <fmt/format.h>

#include <algorithm>

#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/records/record_file.hpp"
#include "labmouse/lab/records/record_reasons.hpp"

namespace labmouse {
namespace {

RunRecord play(const RecordFile& file, const Maze& maze) {
  std::vector<Action> actions;
  for (const StepRecord& step : file.run.steps) actions.push_back(step.action);
  Script script(maze.size(), std::move(actions));
  Rules rules = file.rules;
  // A record without its last line may stop anywhere, so the replay stops after its last step.
  if (!file.ended) rules.budget = std::min(rules.budget, static_cast<int>(file.run.steps.size()));
  return run(maze, rules, script);
}

bool same_pose(const Pose& was, const Pose& is, const GivenFields& given) {
  return (!given.cell || was.cell == is.cell) && (!given.heading || was.heading == is.heading);
}

bool agree(const StepRecord& was, const StepRecord& is, const GivenFields& given) {
  return was.step == is.step && was.action == is.action && (!given.run || was.run == is.run) &&
         same_pose(was.pose, is.pose, given) && (!given.reading || was.sighting == is.sighting) &&
         (!given.blocked || was.blocked == is.blocked);
}

/// The given parts of a pose, in words: "at (0,0) heading north".
std::string pose_words(const Pose& pose, const GivenFields& given) {
  std::string words = given.cell ? fmt::format("at ({},{})", pose.cell.x, pose.cell.y) : "";
  if (given.heading) words += fmt::format("{}heading {}", words.empty() ? "" : " ", name_of(pose.heading));
  return words;
}

/// The given fields of a step, in words.
std::string step_words(const StepRecord& step, const GivenFields& given) {
  std::vector<std::string> words;
  if (given.run) words.emplace_back(step.run == Run::speed ? "in the speed run" : "in the search run");
  if (given.cell || given.heading) words.push_back(pose_words(step.pose, given));
  if (given.reading)
    words.push_back(fmt::format("reading {} {} {}", step.sighting.left, step.sighting.ahead, step.sighting.right));
  if (given.blocked) words.emplace_back(step.blocked ? "blocked" : "not blocked");
  return fmt::format("{}", fmt::join(words, ", "));
}

/// The walls that a wrong reading contradicts: "a wall north of (0,4), no wall west of (0,0)".
std::string wall_words(const Sighting& was, const StepRecord& is) {
  std::vector<std::string> words;
  for (const int quarters : {-1, 0, 1}) {
    const int recorded = was.towards(quarters), played = is.sighting.towards(quarters);
    if (recorded == played) continue;
    const Heading side = turned(is.pose.heading, quarters);
    const Cell cell = neighbour(is.pose.cell, side, std::min(recorded, played));
    const char* is_there = recorded < played ? "no" : "a";
    words.push_back(fmt::format("{} wall {} of ({},{})", is_there, name_of(side), cell.x, cell.y));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Describes a step whose record and replay differ.
std::string difference(const StepRecord& was, const StepRecord& is, GivenFields given) {
  // Run and `blocked` are named only where they differ.
  given.run = given.run && was.run != is.run;
  given.blocked = given.blocked && was.blocked != is.blocked;
  const GivenFields all = {given.run, true, true, true, given.blocked};
  std::string words = fmt::format("recorded {}; replayed {}", step_words(was, given), step_words(is, all));
  // A reading at another pose says nothing about these walls.
  if (given.reading && was.sighting != is.sighting && same_pose(was.pose, is.pose, given))
    words += fmt::format("; the maze has {}", wall_words(was.sighting, is));
  return words;
}

/// Where the steps disagree, or nothing.
std::string compare_steps(const RecordFile& file, const RunRecord& played) {
  for (std::size_t i = 0; i < file.run.steps.size(); ++i) {
    if (i >= played.steps.size())
      return fmt::format("step {} is recorded, but the contest ended before it ({})", i + 1, name_of(played.outcome));
    const GivenFields given = i < file.given.size() ? file.given[i] : GivenFields();
    if (!agree(file.run.steps[i], played.steps[i], given))
      return fmt::format("step {}: {}", i + 1, difference(file.run.steps[i], played.steps[i], given));
  }
  return "";
}

std::string end_words(const RunRecord& run, const GivenFields& given) {
  const std::string pose = pose_words(run.end, given);
  return fmt::format("'{}'{}{}", name_of(run.outcome), pose.empty() ? "" : " ", pose);
}

/// Where the ends disagree, or nothing.
std::string compare_ends(const RecordFile& file, const RunRecord& played) {
  if (!file.ended) return "";
  if (played.steps.size() != file.run.steps.size())
    return fmt::format("the record ends after step {}, but the contest continues", file.run.steps.size());
  if (played.outcome == file.run.outcome && same_pose(file.run.end, played.end, file.given_end)) return "";
  return fmt::format("the record ends {}; replayed, it ends {}", end_words(file.run, file.given_end),
                     end_words(played, GivenFields()));
}

/// Where the reasons are not of this maze, or nothing.
std::string compare_reasons(const RecordFile& file, Size size) {
  for (const StepReasons& each : file.run.reasons)
    if (!fit(each.reasons, size))
      return fmt::format("step {}: its reasons refer to walls that the maze does not have", each.step);
  return "";
}

}  // namespace

ReplayResult replay(const RecordFile& file, const Maze& maze) {
  ReplayResult result{play(file, maze), ""};
  // A replay cannot repeat the mouse's counts and reasons, so they are copied.
  result.run.counts = file.run.counts;
  result.run.last_words = file.run.last_words;
  result.run.reasons = file.run.reasons;
  result.disagreement = compare_steps(file, result.run);
  if (result.disagreement.empty()) result.disagreement = compare_ends(file, result.run);
  if (result.disagreement.empty()) result.disagreement = compare_reasons(file, maze.size());
  return result;
}

}  // namespace labmouse
