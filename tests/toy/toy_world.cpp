// A world of one file: mice that stumble. Each contest is three contests in steps. A random draw decides for each
// whether the mouse stumbles; the best of the others counts and is recorded. If the mouse stumbles in all three, the
// contest has no score.
#include <fmt/format.h>

#include <array>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/replays/replay.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/standings/mouse_figures.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/steps/steps_files.hpp"
#include "tests/toy/toy_entry.hpp"

namespace labmouse {
namespace {

// 1. Its figures and fields: what stands in stores, in JSON, in CSV and in the leaderboard.
struct ToyFigures : Figures {
  std::int64_t stumbles = 0;
};

constexpr std::array<ContestField, 5> contest_fields = {{{"maze", fields::maze_name},
                                                         {"seed", fields::seed},
                                                         {"outcome", fields::outcome},
                                                         {"score", fields::score},
                                                         {"stumbles", fields::figure<&ToyFigures::stumbles>}}};
constexpr std::array<ContestField, 4> csv_fields = {{{"mouse", fields::mouse_name},
                                                     {"maze", fields::maze_name},
                                                     {"score", fields::score},
                                                     {"stumbles", fields::figure<&ToyFigures::stumbles>}}};
constexpr std::array<MouseField, 5> mouse_fields = {{{"name", fields::name},
                                                     {"finished", fields::finished},
                                                     {"runs", fields::runs},
                                                     {"mean_score", fields::mean_all},
                                                     {"interval", fields::interval}}};
constexpr std::array<MazeField, 4> maze_fields = {
    {{"name", fields::name}, {"width", fields::width}, {"height", fields::height}, {"bound", fields::bound}}};
constexpr std::array<Column, 3> columns_of_table = {
    {{"", "finished", 9, columns::finished},
     {"mean", "score", 7, columns::mean_all},
     {"stumbles", "a contest", 9, [](const Race& race, const Standing& standing) {
        return columns::number(mean_of_all(race, standing, "stumbles"), 2);
      }}}};
constexpr WorldFields all_fields = {contest_fields,   csv_fields,
                                    mouse_fields,     maze_fields,
                                    columns_of_table, stored_figures<ToyFigures, &ToyFigures::stumbles>};

// 2. Its settings: what can be set, and which member of the conditions it is.
struct ToyConditions {
  int clumsiness = 50;
};
constexpr std::array rows = {row<&ToyConditions::clumsiness>({.name = "clumsiness",
                                                              .placeholder = "PERCENT",
                                                              .meaning = "How often a mouse stumbles",
                                                              .default_value = "50",
                                                              .high = 100})};

// 3. The world: who may enter, what a maze allows, what one contest is, and what it comes to.
class ToyWorld final : public World {
 public:
  explicit ToyWorld(const ToyConditions& conditions)
      : World({.name = "toy",
               .formula = "the best of three runs in which the mouse did not stumble",
               .conditions = conditions_of(rows, conditions),
               .fields = &all_fields,
               .is_stochastic = true,
               .unit = "steps",
               .limit_score = Rules().failure_score}),
        conditions_(conditions) {}
  std::string refuse(const Contestant& mouse) const override {
    return mouse.walks() ? "" : fmt::format("mouse '{}' cannot walk", mouse.name);
  }
  MazeFacts facts(const Maze& maze) const override { return {bound_of(maze, Rules()).score, {}, {}}; }

  ContestOutput hold(const Race& race, ContestResult& result, Keep keep, const std::atomic<bool>*) const override {
    Rng rng(result.seed);
    const Maze& maze = race.mazes[result.maze].maze;
    ContestOutput held;
    auto figures = std::make_shared<ToyFigures>();
    for (std::uint64_t run = 0; run < 3; ++run) {
      const bool stumbled = rng.below(100) < conditions_.clumsiness;
      if (stumbled && ++figures->stumbles > 0) continue;
      const auto strategy = race.mice[result.mouse].strategy(maze, brief(maze, {}, result.seed + run));
      const RunRecord record = labmouse::run(maze, Rules(), *strategy);
      const auto value = score(record, Rules()).value;
      if (!value || (result.score && *value >= *result.score)) continue;
      result.score = value;
      if (!keep.record) continue;
      RecordFile file = record_file_of(race.mice[result.mouse], race.mazes[result.maze], Rules(), result.seed, record);
      file.world = traits().name;
      held.record = write_record(file);
    }
    result.outcome = result.score ? "finished" : "stumbled";
    result.counted = result.score;
    if (const auto& bound = race.facts[result.maze].bound; result.score && bound) result.ratio = *result.score / *bound;
    result.figures = figures;
    result.done = true;
    return held;
  }

  std::string notes(const Race&) const override { return score_note(*this); }

 private:
  ToyConditions conditions_;
};

}  // namespace

// 4. Its entry on the list: its name, its settings, how it is made of them, and how reports take its records.
const WorldEntry toy_entry = {
    .name = "toy",
    .summary = "mice that stumble",
    .settings = settings_of<rows>,
    .make = make_by<rows, [](const ToyConditions& conditions) { return std::make_shared<ToyWorld>(conditions); }>,
    .records = &steps_records};

}  // namespace labmouse
