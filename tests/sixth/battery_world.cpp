// A sixth world as a sketch: the world of robots without errors, but for a battery that does not always last. A
// random draw decides for each contest what part of the time limit the mouse has. Whatever serves all worlds serves
// this one, too.
#include <fmt/format.h>

#include <array>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_coverage.hpp"
#include "labmouse/lab/drive/drive_fields.hpp"
#include "labmouse/lab/drive/drive_results.hpp"
#include "labmouse/lab/drive/drive_world.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/replays/replay.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "tests/sixth/battery_entry.hpp"

namespace labmouse {
namespace {

struct BatteryConditions {
  std::string robot = "classic";
  int noise = 1;
};
constexpr std::array rows = {
    row<&BatteryConditions::robot>(
        {.name = "robot", .placeholder = "ROBOT", .meaning = "Robot", .default_value = "classic"}),
    row<&BatteryConditions::noise>({.name = "noise",
                                    .placeholder = "N",
                                    .meaning = "How often the time is shortened at random",
                                    .default_value = "1",
                                    .high = 9})};

class BatteryWorld final : public DriveWorld {
 public:
  BatteryWorld(const DriveRules& rules, std::shared_ptr<const DriveModel> model, BatteryConditions conditions)
      : DriveWorld({.name = "battery",
                    .conditions = conditions_of(rows, conditions),
                    .fields = &seconds_fields(),
                    .is_stochastic = true},
                   rules, std::move(model)),
        conditions_(std::move(conditions)) {}

  std::string refuse(const Contestant& mouse) const override { return refuse_to_drive({&mouse, 1}); }
  using DriveWorld::refuse;
  std::string notes(const Race&) const override { return score_note(*this); }

 private:
  DrivenContest drive(const Contestant& mouse, const Maze& maze, const ContestResult& contest, const CellSet& reachable,
                      bool /*traced*/, const std::atomic<bool>* /*stop*/) const override {
    DriveRules lasting = rules();
    Rng rng(contest.seed);
    for (int times = 0; times < conditions_.noise; ++times)
      lasting.time_limit -= lasting.time_limit * rng.below(100) / 100;
    const auto strategy = mouse.driving_strategy(maze, brief(maze, lasting, model(), contest.seed));
    DrivenContest driven;
    driven.record = labmouse::drive(maze, lasting, model(), *strategy);
    driven.coverage = coverage_of(driven.record, maze, reachable);
    return driven;
  }

  std::shared_ptr<DriveFigures> own_figures(const DrivenContest&, const DriveScore&) const override {
    return std::make_shared<SecondsFigures>();
  }

  BatteryConditions conditions_;
};

WorldResult make(const WorldSettings& chosen) {
  BatteryConditions conditions;
  if (std::string error = choose(rows, chosen, conditions); !error.empty()) return {nullptr, error};
  FoundRobot robot = find_robot(conditions.robot);
  if (!robot.errors.empty()) return {nullptr, robot.errors.front()};
  auto model = std::make_shared<DriveModel>(std::move(robot.model));
  return {std::make_shared<BatteryWorld>(find_rules("all-japan").rules, std::move(model), std::move(conditions)), ""};
}

}  // namespace

const WorldEntry battery_entry = {.name = "battery",
                                  .summary = "a robot whose battery may not last",
                                  .settings = settings_of<rows>,
                                  .make = make,
                                  .records = &drive_records};

}  // namespace labmouse
