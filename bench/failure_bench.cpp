// Time of a contest with the failure model and in the physical world: with a strategy, and with a script of the
// decisions that the strategy made there. The script shows the cost of the worlds alone.
#include <benchmark/benchmark.h>

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "bench_mazes.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/lab/failure_rates/failure_file.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

enum class In { failures, physical };
enum class By { strategy, script };

class Contests {
 public:
  explicit Contests(std::string_view mouse) : mouse_(*find_mouse(mouse)) {
    share_route_tables(model_);
    conditions_.errors.variation = 1.0;
  }

  std::size_t count() const { return mazes_.size(); }
  PhysicalRecord held_by_strategy(In world, std::size_t i) const {
    const auto strategy = mouse_.drive(brief(mazes_[i], rules_, model_, i), Settings(mouse_.parameters));
    return held(world, i, *strategy);
  }
  PhysicalRecord held_by_script(In world, std::size_t i, const PhysicalRecord& record) const {
    std::vector<double> paces;
    for (const DriveRun& run : record.drive.runs) paces.push_back(run.pace);
    Script script(mazes_[i].size(), record.actions, std::move(paces));
    return held(world, i, script);
  }

 private:
  PhysicalRecord held(In world, std::size_t i, DrivingStrategy& mouse) const {
    if (world == In::failures) return drive_with_failures(mazes_[i], rules_, model_, conditions_, rates_, i, mouse);
    return drive_physically(mazes_[i], rules_, model_, conditions_, i, mouse);
  }

  const BuiltinMouse& mouse_;
  std::vector<Maze> mazes_ = bench_mazes(16);
  DriveModel model_ = find_robot("kerise").model;
  DriveRules rules_ = find_rules("all-japan").rules;
  FailureRates rates_ = rates_of(*find_rates("kerise").file);
  PhysicalConditions conditions_;
};

void contest(benchmark::State& state, std::string_view mouse, In world, By by) {
  const Contests contests(mouse);
  std::vector<PhysicalRecord> records;
  for (std::size_t i = 0; by == By::script && i < contests.count(); ++i)
    records.push_back(contests.held_by_strategy(world, i));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(by == By::strategy ? contests.held_by_strategy(world, i)
                                                : contests.held_by_script(world, i, records[i]));
    i = (i + 1) % contests.count();
  }
}
BENCHMARK_CAPTURE(contest, flood_return_failures, "flood-return", In::failures, By::strategy);
BENCHMARK_CAPTURE(contest, flood_return_physical, "flood-return", In::physical, By::strategy);
BENCHMARK_CAPTURE(contest, certify_failures, "certify", In::failures, By::strategy);
BENCHMARK_CAPTURE(contest, certify_physical, "certify", In::physical, By::strategy);
BENCHMARK_CAPTURE(contest, script_failures, "flood-return", In::failures, By::script);
BENCHMARK_CAPTURE(contest, script_physical, "flood-return", In::physical, By::script);

}  // namespace
}  // namespace labmouse
