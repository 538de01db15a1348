// Binds seasons of a league, for clusters: the contests of their entries.
#include <fmt/format.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <chrono>
#include <memory>
#include <utility>

#include "bindings.hpp"
#include "errors.hpp"
#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/league/season_site.hpp"
#include "part_store.hpp"
#include "running.hpp"
#include "work.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

/// A finished season, or the part of it that was run.
struct HeldSeason {
  League league;
  SeasonRaces races;
  std::size_t from_store = 0;  ///< contests that were taken from the store and not run

  bool complete() const { return !races.stopped && races.not_judged == 0; }
};

/// Throws UserError.
League valid_league(const std::string& folder, const std::string& python, bool sandbox, std::vector<std::string> hidden,
                    const std::atomic<bool>* stop) {
  ExternalOptions options;
  options.python = python;
  options.sandbox = sandbox ? SandboxUse::always : SandboxUse::never;
  options.stop = stop;
  League league = load_league(folder, options, std::move(hidden));
  league.errors.insert(league.errors.end(), league.entry_errors.begin(), league.entry_errors.end());
  if (!league.errors.empty()) throw UserError(fmt::format("{}", fmt::join(league.errors, "\n")));
  return league;
}

/// A season that runs in a thread.
class RunningSeason {
 public:
  RunningSeason(const std::string& folder, const std::string& secret, const std::string& python, bool sandbox, int jobs,
                const std::string& records, const GivenStore& store)
      : held_(std::make_shared<HeldSeason>()) {
    std::vector<std::string> hidden;
    for (const std::string& path : {records, std::get<0>(store)})
      if (!path.empty()) hidden.push_back(path);
    held_->league = valid_league(folder, python, sandbox, std::move(hidden), &work_.stopped());
    if (sha256_text(secret) != held_->league.season.seed_hash)
      throw UserError(fmt::format("{}: the season has another seed; give all machines the same files", folder));
    SeasonOrder order;
    order.secret = secret;
    order.jobs = jobs;
    order.records = records;
    order.store = store_.emplace(store).shown();
    order.stop = &work_.stopped();
    order.advanced = [this](std::size_t all, bool ran) {
      work_.advance(all);
      const auto now = Clock::now();
      const double seconds = std::chrono::duration<double>(now - std::exchange(told_, now)).count();
      if (ran) spent_ += seconds;
    };
    told_ = Clock::now();
    work_.start([this, order] { held_->races = run_season(held_->league, order); });
  }

  Work& work() { return work_; }
  const std::vector<std::string>& remarks() const { return held_->league.remarks; }
  std::map<std::string, std::string> settings() const { return {}; }
  std::shared_ptr<HeldSeason> result() {
    work_.finish();
    held_->from_store += store_->finish();
    if (!held_->races.error.empty()) throw UserError(held_->races.error);
    return held_;
  }
  std::vector<PickedContest> missing() const { return store_->missing(); }
  double spent() const { return spent_; }

 private:
  using Clock = std::chrono::steady_clock;

  std::shared_ptr<HeldSeason> held_;
  std::optional<RaceStore> store_;
  double spent_ = 0.0;
  Clock::time_point told_;
  Work work_;  // last, so that its thread ends before the members that it uses
};

/// Throws UserError.
std::string season_seed(const std::string& folder, const std::string& seed_file) {
  const League league = valid_league(folder, "", false, {}, nullptr);
  SecretSeed seed = read_secret_seed_of(league, seed_file);
  if (!seed.error.empty()) throw UserError(seed.error);
  return std::move(seed.secret);
}

}  // namespace

void bind_seasons(nb::module_& module) {
  nb::class_<HeldSeason>(module, "HeldSeason")
      .def_prop_ro("complete", &HeldSeason::complete)
      .def_prop_ro("from_store", [](const HeldSeason& held) { return held.from_store; })
      .def("table", [](const HeldSeason& held) { return table_of(results_of(held.league, held.races)); })
      .def("json", [](const HeldSeason& held) { return json_of(results_of(held.league, held.races)); });
  nb::class_<RunningSeason> season(module, "RunningSeason");
  season
      .def(nb::init<const std::string&, const std::string&, const std::string&, bool, int, const std::string&,
                    const GivenStore&>(),
           "folder"_a, "seed"_a, "python"_a, "sandbox"_a, "jobs"_a, "records"_a, "store"_a)
      .def_prop_ro("spent", &RunningSeason::spent, "The seconds of all contests that ran, in one thread.");
  bind_running(season);
  module.def("season_seed", &season_seed, "folder"_a, "seed_file"_a,
             "The seed of the season in that folder. Raises Error if it has another hash than the season file.");
}

}  // namespace labmouse::python
