// Binds comparisons until a verdict: sequential tests of mice.
#include "labmouse/lab/studies/compare.hpp"

#include <fmt/format.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <memory>

#include "bindings.hpp"
#include "entering.hpp"
#include "errors.hpp"
#include "orders.hpp"
#include "part_store.hpp"
#include "running.hpp"
#include "work.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

struct HeldComparison {
  Compared compared;
  std::size_t from_store = 0;  ///< contests that were taken from the store and not run
};

/// Kind, width, height and thousandths of loops of generated mazes.
using GivenGenerator = std::tuple<std::string, int, int, int>;
/// better_by, alpha, beta, whether the test is gsprt, most mazes, seed, and number of threads.
using GivenTest = std::tuple<double, double, double, bool, std::size_t, std::uint64_t, int>;
/// The number of the first maze of the batch to run; none for a whole comparison.
using GivenBatch = std::optional<std::size_t>;

/// A comparison that runs in a thread.
class RunningComparison {
 public:
  RunningComparison(const GivenMice& mice, bool first_is_own, std::vector<NamedMaze> mazes,
                    const GivenGenerator& generator, const GivenWorld& world, const GivenTest& test,
                    const GivenStore& store, const GivenBatch& batch) {
    CompareOrder order;
    bool gsprt = false;
    std::tie(order.test.better_by, order.test.alpha, order.test.beta, gsprt, order.most, order.race.seed,
             order.race.jobs) = test;
    order.test.method = gsprt ? SequentialMethod::gsprt : SequentialMethod::bets;
    order.mazes = source_of(mazes, generator, order.race.seed);
    if (mazes.empty()) mazes = {drawn_maze(order.mazes, order.race.seed, 0)};
    Choice choice = choice_of(mice, std::move(mazes), world);
    const std::string name = first_name(choice, first_is_own);
    Field field = enter(std::move(choice), &work_.stopped());
    if (!order.mazes.list.empty()) order.mazes.list = std::move(field.mazes);
    remarks_ = std::move(field.remarks);
    settings_ = {field.entry.settings.begin(), field.entry.settings.end()};
    order.race.world = field.entry.world;
    order.race.store = store_.emplace(store).shown();
    order.race.files = {std::get<0>(store)};
    std::vector<Contestant>& all = field.entry.mice;
    if (all.size() < 2) throw UserError("there is nothing to compare; name two mice or more that differ");
    const auto first =
        std::find_if(all.begin(), all.end(), [&](const Contestant& mouse) { return mouse.name == name; });
    std::rotate(all.begin(), first, first + 1);
    held_ = std::make_shared<HeldComparison>();
    work_.start([this, order, batch, all = std::move(field.entry.mice)]() mutable {
      if (batch) {
        // The client takes the contests from the store.
        static_cast<void>(shares_of_batch(std::move(all), order, {*batch, &work_.stopped()}));
        return;
      }
      CompareHooks hooks;
      hooks.stop = &work_.stopped();
      hooks.lacks_contests = [this] { return !store_->missing().empty(); };
      hooks.advanced = [this](const Compared& compared) {
        while (work_.done() < compared.mazes) work_.advance(compared.order.most);
      };
      held_->compared = hold_comparison(std::move(all), order, hooks);
    });
  }

  Work& work() { return work_; }
  const std::vector<std::string>& remarks() const { return remarks_; }
  const std::map<std::string, std::string>& settings() const { return settings_; }
  std::shared_ptr<HeldComparison> result() {
    work_.finish();
    held_->from_store += store_->finish();
    return held_;
  }
  std::vector<PickedContest> missing() const { return store_->missing(); }

 private:
  static MazeSource source_of(const std::vector<NamedMaze>& mazes, const GivenGenerator& given, std::uint64_t seed) {
    MazeSource source;
    source.list = mazes;
    const auto& [kind, width, height, loops] = given;
    source.generator = find_generator(kind);
    if (source.generator == nullptr) throw UserError(fmt::format("there is no generator '{}'", kind));
    source.order = {{width, height}, seed, loops};
    if (const auto reason = source.generator->refuses(source.order); !reason.empty())
      throw UserError(std::string(reason));
    return source;
  }

  /// The name of the mouse that stands first among the SPECs, or among the own mice.
  std::string first_name(Choice choice, bool is_own) const {
    if (is_own) return choice.own.front().name;
    choice.own.clear();
    choice.specs.resize(1);
    const std::vector<Contestant> mice = enter(std::move(choice), &work_.stopped()).entry.mice;
    if (mice.size() != 1) throw UserError(fmt::format("'first' names {} mice; give exactly one", mice.size()));
    return mice.front().name;
  }

  std::shared_ptr<HeldComparison> held_;
  std::vector<std::string> remarks_;
  std::map<std::string, std::string> settings_;
  std::optional<RaceStore> store_;
  Work work_;  // last, so that its thread ends before the members that it uses
};

}  // namespace

void bind_comparisons(nb::module_& module) {
  nb::class_<HeldComparison>(module, "HeldComparison")
      .def_prop_ro("complete", [](const HeldComparison& held) { return !held.compared.stopped; })
      .def_prop_ro("from_store", [](const HeldComparison& held) { return held.from_store; })
      .def("table", [](const HeldComparison& held) { return table_of(held.compared); })
      .def("json", [](const HeldComparison& held) { return json_of(held.compared); });
  nb::class_<RunningComparison> comparison(module, "RunningComparison");
  comparison.def(nb::init<const GivenMice&, bool, std::vector<NamedMaze>, const GivenGenerator&, const GivenWorld&,
                          const GivenTest&, const GivenStore&, const GivenBatch&>(),
                 "mice"_a, "first_is_own"_a, "mazes"_a, "generator"_a, "world"_a, "test"_a, "store"_a,
                 "batch"_a = nb::none());
  bind_running(comparison);
  module.def(
      "batch_of", [](const std::string& maze) { return batch_of(maze); }, "maze"_a,
      "The batch of a comparison in which a drawn maze of that name is raced in.");
}

}  // namespace labmouse::python
