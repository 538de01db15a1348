// Binds races: many mice on many mazes.
#include <fmt/format.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "bindings.hpp"
#include "entering.hpp"
#include "errors.hpp"
#include "labmouse/lab/numbers/verdict.hpp"
#include "labmouse/lab/result_folders/race_folder.hpp"
#include "labmouse/lab/result_folders/results_folder.hpp"
#include "labmouse/lab/standings/maze_scores.hpp"
#include "labmouse/lab/standings/mouse_pair.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/store/store_changes.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "orders.hpp"
#include "part_store.hpp"
#include "running.hpp"
#include "values.hpp"
#include "work.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

/// A finished race, or the part of a stopped one that was run.
struct HeldRace {
  Race race;
  std::vector<SkippedFile> skipped;
  std::size_t from_store = 0;  ///< contests that were taken from the store and not run
};

/// A race that runs in a thread.
class RunningRace {
 public:
  /// Contests of similar duration: the name of the mouse, and the number of cells of the maze.
  using Kind = std::pair<std::string, int>;
  /// The number of contests, and their total time in seconds.
  using Spent = std::pair<int, double>;

  RunningRace(const GivenMice& mice, std::vector<NamedMaze> mazes, const GivenWorld& world, std::optional<int> runs,
              std::uint64_t seed, int jobs, const std::string& out, bool overwrite, const GivenStore& store)
      : out_(out) {
    if (runs && (*runs < 1 || *runs > 1'000'000))
      throw UserError(fmt::format("runs is a number from 1 to 1000000, not {}", *runs));
    if (jobs < 0 || jobs > 1024) throw UserError(fmt::format("jobs is a number from 0 to 1024, not {}", jobs));
    Field field = enter(choice_of(mice, std::move(mazes), world), &work_.stopped());
    remarks_ = std::move(field.remarks);
    settings_ = {field.entry.settings.begin(), field.entry.settings.end()};
    held_ = std::make_shared<HeldRace>();
    held_->skipped = std::move(field.skipped);
    RaceOrder order;
    order.world = field.entry.world;
    order.runs = runs.value_or(find_world(order.world->traits().name)->usual_runs);
    order.seed = seed;
    order.jobs = jobs;
    order.store = store_.emplace(store).shown();
    order.files = {std::get<0>(store), out_};
    const std::size_t all = contests_of(field.entry.mice, field.mazes.size(), order);
    if (!out_.empty()) {
      folder_ = std::make_unique<ResultsFolder>(out_, overwrite);
      if (!folder_->error().empty()) throw UserError(folder_->error());
    }
    told_ = Clock::now();
    work_.start([this, order, all, field = std::move(field)]() mutable {
      RaceHooks hooks;
      hooks.stop = &work_.stopped();
      if (!out_.empty()) hooks.keep = RaceFolder::keep;
      hooks.finished = [this, all](const Race& race, const ContestResult& contest, const ContestOutput& held) {
        work_.advance(all);
        note_time(race, contest);
        save(race, contest, held);
      };
      held_->race = hold_race(std::move(field.entry.mice), std::move(field.mazes), order, hooks);
      save_results();
    });
  }

  Work& work() { return work_; }
  const std::vector<std::string>& remarks() const { return remarks_; }
  const std::map<std::string, std::string>& settings() const { return settings_; }
  std::shared_ptr<HeldRace> result() {
    work_.finish();
    held_->from_store += store_->finish();
    return held_;
  }
  std::vector<PickedContest> missing() const { return store_->missing(); }
  const std::map<Kind, Spent>& spent() const { return spent_; }

 private:
  using Clock = std::chrono::steady_clock;

  void note_time(const Race& race, const ContestResult& contest) {
    auto& [contests, seconds] = spent_[{race.mice[contest.mouse].name, race.mazes[contest.maze].maze.size().area()}];
    const auto now = Clock::now();
    ++contests;
    seconds += std::chrono::duration<double>(now - std::exchange(told_, now)).count();
  }

  void save(const Race& race, const ContestResult& contest, const ContestOutput& held) {
    if (out_.empty() || !failed_write_.empty()) return;
    if (!records_) records_.emplace(out_, race);
    if (failed_write_ = records_->save(contest, held); !failed_write_.empty()) work_.stop();
  }

  void save_results() {
    if (out_.empty()) return;
    const std::string path = fmt::format("{}/{}", out_, results_file_name);
    if (failed_write_.empty()) {
      const std::string error = write_file(path, [&](const TextSink& sink) {
        write_json({&held_->race, 1}, held_->skipped, sink);
      });
      if (!error.empty()) failed_write_ = fmt::format("{}: error: {}", path, error);
    }
    folder_.reset();
    if (!failed_write_.empty()) throw UserError(failed_write_);
  }

  std::shared_ptr<HeldRace> held_;
  std::vector<std::string> remarks_;
  std::map<std::string, std::string> settings_;
  std::string out_, failed_write_;
  std::unique_ptr<ResultsFolder> folder_;
  std::optional<RaceFolder> records_;
  std::optional<RaceStore> store_;
  std::map<Kind, Spent> spent_;
  Clock::time_point told_;
  Work work_;  // last, so that its thread ends before the members that it uses
};

std::vector<std::string> names(const HeldRace& held, bool mice) {
  std::vector<std::string> found;
  if (mice)
    for (const Contestant& mouse : held.race.mice) found.push_back(mouse.name);
  else
    for (const NamedMaze& maze : held.race.mazes) found.push_back(maze.name);
  return found;
}

/// A list of values for each field, by its name.
template <class Fields, class Rows, class ValueOf>
nb::dict columns_of(const Fields& fields, const Rows& rows, ValueOf value_of) {
  nb::dict columns;
  for (const auto& field : fields) {
    nb::list values;
    for (const auto& row : rows) values.append(object_of(value_of(field, row)));
    columns[nb::str(field.key.data(), field.key.size())] = values;
  }
  return columns;
}

nb::dict contests(const HeldRace& held) {
  std::vector<const ContestResult*> done;
  for (const ContestResult& contest : held.race.results)
    if (contest.done) done.push_back(&contest);
  return columns_of(
      held.race.world().traits().fields->csv, done,
      [&](const ContestField& field, const ContestResult* contest) { return field.of(held.race, *contest); });
}

nb::dict standings(const HeldRace& held) {
  return columns_of(held.race.world().traits().fields->mouse, standings_of(held.race),
                    [&](const MouseField& field, const Standing& standing) { return field.of(held.race, standing); });
}

nb::dict mazes(const HeldRace& held) {
  std::vector<std::size_t> places(held.race.mazes.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  return columns_of(held.race.world().traits().fields->maze, places,
                    [&](const MazeField& field, std::size_t maze) { return field.of(held.race, maze); });
}

std::size_t position(const Race& race, const std::string& mouse) {
  for (std::size_t i = 0; i < race.mice.size(); ++i)
    if (race.mice[i].name == mouse) return i;
  std::vector<std::string_view> names;
  for (const Contestant& each : race.mice) names.push_back(each.name);
  throw UserError(fmt::format("no mouse '{}' is in this race; its mice are {}", mouse, fmt::join(names, ", ")));
}

/// The paired difference of two mice, as the fields of labmouse.Comparison.
nb::dict compare(const HeldRace& held, const std::string& mouse, const std::string& against) {
  const MousePair pair =
      pair_of(maze_scores(held.race, position(held.race, mouse)), maze_scores(held.race, position(held.race, against)),
              !held.race.world().traits().failure_score, held.race.order.seed);
  const PairedDifference& found = pair.scores;
  nb::dict fields;
  fields["mouse"] = mouse;
  fields["against"] = against;
  fields["mazes"] = found.count;
  fields["mean"] = found.mean;
  fields["low"] = found.interval.low;
  fields["high"] = found.interval.high;
  fields["better"] = found.below;
  fields["equal"] = found.equal;
  fields["worse"] = found.above;
  fields["sign_test"] = found.sign_test;
  fields["p"] = found.p;
  fields["verdict"] = std::string(name_of(verdict_of(found, found.p)));
  fields["finish_rate"] = nb::none();
  if (pair.has_rates) {
    const PairedDifference& failed = pair.rates.failed;
    const Interval interval = scaled(failed.interval, -1.0);
    fields["finish_rate"] =
        nb::make_tuple(-failed.mean, interval.low, interval.high, std::string(name_of(verdict_of(failed, failed.p))));
  }
  return fields;
}

/// Merges stores into the target. Returns how many contests are new in it. Throws UserError.
std::int64_t merge(const std::vector<std::string>& paths, const std::string& target) {
  // The target needs no check: a race on a cluster has opened it before, which checks it.
  const Merge merged = merge_stores(paths, target, TargetCheck::done_before);
  if (!merged.error.empty()) throw UserError(merged.error);
  if (!merged.conflicts.empty()) throw UserError(fmt::format("{}", fmt::join(merged.conflicts, "\n")));
  return merged.added;
}

}  // namespace

void bind_races(nb::module_& module) {
  nb::class_<HeldRace>(module, "HeldRace")
      .def_prop_ro("complete", [](const HeldRace& held) { return !held.race.stopped; })
      .def_prop_ro("world", [](const HeldRace& held) { return std::string(held.race.world().traits().name); })
      .def_prop_ro("seed", [](const HeldRace& held) { return held.race.order.seed; })
      .def_prop_ro("mice", [](const HeldRace& held) { return names(held, true); })
      .def_prop_ro("mazes", [](const HeldRace& held) { return names(held, false); })
      .def_prop_ro("from_store", [](const HeldRace& held) { return held.from_store; })
      .def_prop_ro("contests", [](const HeldRace& held) { return held.race.results.size(); })
      .def("contest_columns", &contests, nb::sig("def contest_columns(self) -> dict[str, list[object]]"))
      .def("standing_columns", &standings, nb::sig("def standing_columns(self) -> dict[str, list[object]]"))
      .def("maze_columns", &mazes, nb::sig("def maze_columns(self) -> dict[str, list[object]]"))
      .def("compare", &compare, "mouse"_a, "against"_a,
           nb::sig("def compare(self, mouse: str, against: str) -> dict[str, typing.Any]"))
      .def("leaderboard", [](const HeldRace& held) { return table_of(held.race, false); })
      .def("heading", [](const HeldRace& held) { return heading_of(held.race); })
      .def("cells", [](const HeldRace& held) { return cells_of(held.race); })
      .def("notes", [](const HeldRace& held) { return notes_of(held.race); })
      .def("csv", [](const HeldRace& held) { return csv_of(held.race); })
      .def("json", [](const HeldRace& held) { return json_of(held.race, held.skipped); });
  nb::class_<RunningRace> race(module, "RunningRace");
  race.def(nb::init<const GivenMice&, std::vector<NamedMaze>, const GivenWorld&, std::optional<int>, std::uint64_t, int,
                    const std::string&, bool, const GivenStore&>(),
           "mice"_a, "mazes"_a, "world"_a, "runs"_a, "seed"_a, "jobs"_a, "out"_a, "overwrite"_a, "store"_a)
      .def("spent", &RunningRace::spent,
           "The number of contests and their seconds, by the name of the mouse and the number of cells of the maze. "
           "Valid for a race in one thread, once it has ended.");
  bind_running(race);
  module.def("merge_stores", &merge, "paths"_a, "target"_a, nb::call_guard<nb::gil_scoped_release>(),
             "Merges stores as `labmouse store merge` does. Returns how many contests are new in the target. Raises "
             "Error if stores conflict or cannot be read or written.");
}

}  // namespace labmouse::python
