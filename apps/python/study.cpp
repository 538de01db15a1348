// Binds studies: paired comparisons of mice on mazes that they were not trained on (cross-validation).
#include "labmouse/lab/studies/study.hpp"

#include <fmt/format.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <memory>

#include "bindings.hpp"
#include "entering.hpp"
#include "errors.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "orders.hpp"
#include "part_store.hpp"
#include "running.hpp"
#include "work.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

/// A finished study, or the folds of a stopped one that were run.
struct HeldStudy {
  Study study;
  std::vector<SkippedFile> skipped;
  std::size_t from_store = 0;  ///< contests that were taken from the store and not run
};

/// Number of folds; whether mice learn; runs per maze, or none for the world's default; seed; number of threads.
using GivenNumbers = std::tuple<int, bool, std::optional<int>, std::uint64_t, int>;

/// A study that runs in a thread.
class RunningStudy {
 public:
  RunningStudy(const GivenMice& mice, std::vector<NamedMaze> mazes, const GivenWorld& world,
               const GivenNumbers& numbers, const GivenStore& store) {
    StudyOrder order;
    std::optional<int> runs;
    std::tie(order.folds, order.learning, runs, order.race.seed, order.race.jobs) = numbers;
    if (order.folds < 2) throw UserError(fmt::format("folds is a number from 2, not {}", order.folds));
    if (runs && *runs < 1) throw UserError(fmt::format("runs is a number from 1, not {}", *runs));
    if (order.race.jobs < 0 || order.race.jobs > 1024)
      throw UserError(fmt::format("jobs is a number from 0 to 1024, not {}", order.race.jobs));
    Field field = enter(choice_of(mice, std::move(mazes), world), &work_.stopped());
    remarks_ = std::move(field.remarks);
    settings_ = {field.entry.settings.begin(), field.entry.settings.end()};
    held_ = std::make_shared<HeldStudy>();
    held_->skipped = std::move(field.skipped);
    order.race.world = field.entry.world;
    order.race.runs = runs.value_or(find_world(order.race.world->traits().name)->usual_runs);
    order.race.store = store_.emplace(store).shown();
    order.race.files = {std::get<0>(store)};
    work_.start([this, order, field = std::move(field)]() mutable {
      StudyHooks hooks;
      hooks.stop = &work_.stopped();
      hooks.finished = [this](std::size_t all) { work_.advance(all); };
      held_->study = hold_study(field.entry.mice, std::move(field.mazes), order, hooks);
    });
  }

  Work& work() { return work_; }
  const std::vector<std::string>& remarks() const { return remarks_; }
  const std::map<std::string, std::string>& settings() const { return settings_; }
  std::shared_ptr<HeldStudy> result() {
    work_.finish();
    held_->from_store += store_->finish();
    if (!held_->study.error.empty()) throw UserError(held_->study.error);
    return held_;
  }
  std::vector<PickedContest> missing() const { return store_->missing(); }

 private:
  std::shared_ptr<HeldStudy> held_;
  std::vector<std::string> remarks_;
  std::map<std::string, std::string> settings_;
  std::optional<RaceStore> store_;
  Work work_;  // last, so that its thread ends before the members that it uses
};

}  // namespace

void bind_studies(nb::module_& module) {
  nb::class_<HeldStudy>(module, "HeldStudy")
      .def_prop_ro("complete", [](const HeldStudy& held) { return !held.study.race.stopped; })
      .def_prop_ro("from_store", [](const HeldStudy& held) { return held.from_store; })
      .def("table", [](const HeldStudy& held) { return table_of(held.study, false); })
      .def("csv", [](const HeldStudy& held) { return csv_of(held.study); })
      .def("json", [](const HeldStudy& held) { return json_of(held.study, held.skipped); })
      .def("svg", [](const HeldStudy& held) { return picture_of(held.study); });
  nb::class_<RunningStudy> study(module, "RunningStudy");
  study.def(
      nb::init<const GivenMice&, std::vector<NamedMaze>, const GivenWorld&, const GivenNumbers&, const GivenStore&>(),
      "mice"_a, "mazes"_a, "world"_a, "numbers"_a, "store"_a);
  bind_running(study);
}

}  // namespace labmouse::python
