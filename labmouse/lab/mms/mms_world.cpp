#include "labmouse/lab/mms/mms_world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "labmouse/lab/bounds/mms_bound.hpp"
#include "labmouse/lab/mms/mms_fields.hpp"
#include "labmouse/lab/mms/mms_figures.hpp"
#include "labmouse/lab/mms/mms_notes.hpp"
#include "labmouse/lab/records/mms_record.hpp"
#include "labmouse/lab/records/mms_statistics_json.hpp"
#include "labmouse/lab/replays/mms_drawing.hpp"
#include "labmouse/lab/replays/mms_walk.hpp"
#include "labmouse/lab/text/last_lines.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

/// How many sentences of a run's log a race keeps: the first ones.
constexpr std::size_t kept_log = 3;

std::vector<std::string> kept_sentences(std::vector<std::string> log) {
  log.resize(std::min(log.size(), kept_log));
  for (std::string& sentence : log) sentence.resize(std::min(sentence.size(), kept_text));
  return log;
}

/// The value over the best possible one; nothing if that is 0, as in a maze whose start is a goal.
std::optional<double> ratio(const std::optional<double>& value, const std::optional<double>& best) {
  if (!value || !best || *best <= 0.0) return std::nullopt;
  return *value / *best;
}

double visited_share_of(CellSet visited, const CellSet& reachable) {
  visited &= reachable;
  return visited.count() / static_cast<double>(reachable.count());
}

JsonText list_of(const std::vector<std::string>& lines) { return {one_line(Json(lines))}; }

std::shared_ptr<const Figures> figures_of(const MmsRun& run, const MazeFacts& facts, double visited) {
  const MmsStatistics& statistics = run.statistics;
  auto figures = std::make_shared<MmsFigures>();
  figures->outcome = name_of(run.outcome);
  figures->end = run.end;
  figures->finished = is_scored(run);
  figures->score = {is_cut_short(run.outcome) ? "null" : short_json(statistics.score).dump()};
  if (!is_cut_short(run.outcome)) figures->best_run = best_run(statistics);
  figures->run_ratio = ratio(figures->best_run, facts.best_run);
  figures->statistics = {statistics_json(statistics).dump()};
  figures->total = total(statistics);
  figures->lines = run.lines;
  figures->invalid_lines = run.invalid_lines;
  figures->log = list_of(kept_sentences(run.log));
  figures->errors = list_of(last_lines(run.errors));
  figures->simulated_seconds = run.clock;
  figures->seconds = {run.seconds};
  figures->visited = visited;
  return figures;
}

WorldTraits traits_of(const MmsOptions& options) {
  const double failed = decimal(MmsStatistics().score);
  return {.name = "mms",
          .edition = 2,
          .formula = mms_formula,
          .conditions = conditions_of(mms_rows, options),
          .fields = &mms_fields(),
          .fixed_places = "starts at (0,0) and has its goal in the centre",
          .numbers_runs = false,
          .unit = "points",
          .failure_score = failed,
          .limit_score = failed,
          .why_no_bound = "whose centre cannot be reached"};
}

class MmsWorld final : public World {
 public:
  explicit MmsWorld(const MmsOptions& options) : World(traits_of(options)), options_(options) {}

  std::string refuse(const Contestant& mouse) const override {
    if (std::holds_alternative<MmsProgram>(mouse.kind)) return "";
    return fmt::format("mouse '{}' is not a program for mms; write mms:COMMAND", mouse.name);
  }

  MazeFacts facts(const Maze& maze) const override {
    const MmsBound bound = mms_bound_of(maze);
    return {bound.score, bound.run, reachable_cells(as_in_mms(maze))};
  }

  ContestOutput hold(const Race& race, ContestResult& result, Keep keep, const std::atomic<bool>* stop) const override {
    const NamedMaze& maze = race.mazes[result.maze];
    const Contestant& mouse = race.mice[result.mouse];
    Launch launch = std::get<MmsProgram>(mouse.kind).launch;
    launch.stop = stop;
    MmsWalk walk{HalfPose()};
    std::optional<MmsRecorder> recorder;
    if (keep.record) recorder.emplace(mouse.name, maze);
    MmsRun run = run_mms(launch, maze.maze, options_, [&](const MmsEvent& event, const MmsHost&) {
      walk.add(event);
      if (recorder) recorder->add(event);
    });
    ContestOutput held;
    if (recorder) held.record = recorder->finish(run);
    if (keep.picture) held.picture = draw_mms_run(mouse.name, maze, run, walk);
    sum_up(run, walk.visited(), race.facts[result.maze], result);
    return held;
  }

  std::string notes(const Race& race) const override { return mms_notes(race); }
  std::string remarks(const Race& race) const override { return mms_remarks(race); }

 private:
  MmsOptions options_;
};

}  // namespace

void sum_up(const MmsRun& run, const CellSet& visited, const MazeFacts& facts, ContestResult& result) {
  const MmsStatistics& statistics = run.statistics;
  const bool scored = is_scored(run);
  result.outcome = scored                ? "finished"
                   : statistics.finished ? std::string(name_of(run.outcome))
                                         : fmt::format("unsolved: {}", name_of(run.outcome));
  if (run.outcome != MmsOutcome::complete && run.outcome != MmsOutcome::interrupted && run.lines == 0)
    result.never_started = run.end.empty() ? std::string(name_of(run.outcome)) : run.end;
  result.counted = decimal(scored ? statistics.score : MmsStatistics().score);
  if (scored) {
    result.score = result.counted;
    result.ratio = ratio(result.score, facts.bound);
  }
  result.figures = figures_of(run, facts, visited_share_of(visited, facts.reachable));
  if (run.outcome == MmsOutcome::not_judged) leave_unjudged(result);
  result.done = run.outcome != MmsOutcome::interrupted;
}

std::shared_ptr<const World> mms_world(const MmsOptions& options) { return std::make_shared<MmsWorld>(options); }

}  // namespace labmouse
