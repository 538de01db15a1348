#include <fmt/format.h>

#include <utility>

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_coverage.hpp"
#include "labmouse/lab/drive/drive_fields.hpp"
#include "labmouse/lab/drive/drive_results.hpp"
#include "labmouse/lab/drive/drive_world.hpp"
#include "labmouse/lab/drive/drive_worlds.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/mice/stoppable.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

class SecondsWorld final : public DriveWorld {
 public:
  using DriveWorld::DriveWorld;

  std::string refuse(const Contestant& mouse) const override {
    const std::string reason = refuse_in_laps(mouse);
    return reason.empty() ? refuse_to_drive({&mouse, 1}) : reason;
  }
  using DriveWorld::refuse;

  std::string notes(const Race& race) const override {
    return fmt::format(
        "Rules {}: {}. Lower is better; mice that finished more contests come first.\nRobot {}, cells of {:g} mm. "
        "{}\n{}\n",
        shown(rules().name), traits().formula, shown(model().robot.name), model().tables.cell,
        rules().counts == Counted::lap
            ? "All mice know the course and drive the same laps."
            : "The search run ends when the first speed run begins; best runs are timed from rest to the centre.",
        bound_words(race));
  }

 private:
  DrivenContest drive(const Contestant& mouse, const Maze& maze, const ContestResult& contest, const CellSet& reachable,
                      bool /*traced*/, const std::atomic<bool>* stop) const override {
    const auto strategy = mouse.driving_strategy(maze, brief(maze, rules(), model(), contest.seed));
    StoppableDriver stoppable(*strategy, stop);
    DrivenContest driven;
    driven.record = labmouse::drive(maze, rules(), model(), stoppable);
    driven.coverage = coverage_of(driven.record, maze, reachable);
    const StrategyReport report = strategy->report();
    driven.words = report.last_words;
    driven.started = report.started;
    return driven;
  }

  std::shared_ptr<DriveFigures> own_figures(const DrivenContest& driven, const DriveScore& /*score*/) const override {
    auto figures = std::make_shared<SecondsFigures>();
    for (const DriveRun& run : driven.record.runs)
      if (run.has_route()) figures->proven = run.known == run.possible;
    return figures;
  }
};

}  // namespace

std::shared_ptr<const World> seconds_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model) {
  WorldTraits traits = {.name = "seconds",
                        .conditions = drive_conditions(rules, *model, RobotParts::limits),
                        .fields = &seconds_fields()};
  return std::make_shared<SecondsWorld>(std::move(traits), rules, std::move(model));
}

}  // namespace labmouse
