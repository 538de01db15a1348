#include "labmouse/lab/store/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>

#include "labmouse/chance/rng.hpp"
#include "labmouse/lab/mice/external_specs.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/store/contest_key.hpp"
#include "labmouse/lab/store/figures.hpp"
#include "labmouse/lab/system/parallel.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

enum class Presence { here, elsewhere, not_to_be_run };

/// Asks for each program once whether it may be run, and notes those that may not.
class Permissions {
 public:
  Permissions(const VerificationOrder& order, Verification& found) : order_(order), found_(found) {}

  bool may_run(const std::string& spec) {
    const auto [place, is_new] = answers_.try_emplace(spec, false);
    if (is_new) {
      place->second = order_.may_run && order_.may_run(spec);
      if (!place->second) found_.programs.push_back(spec);
    }
    return place->second;
  }

 private:
  const VerificationOrder& order_;
  Verification& found_;
  std::map<std::string, bool> answers_;
};

/// Replaces `mouse`, a description from the store, by the mouse itself, if that is here, unchanged and may be run.
Presence revive(const World& world, Contestant& mouse, const VerificationOrder& order, Permissions& permissions) {
  const std::string spec = spec_of(mouse);
  if (is_external_spec(spec) && !permissions.may_run(spec)) return Presence::not_to_be_run;
  ExternalOptions external_mice = order.external_mice;
  external_mice.sandbox = SandboxUse::always;
  SpecResult read = is_external_spec(spec) ? read_specs(spec, external_mice) : read_builtin_specs(spec);
  const bool same = read.contestants.size() == 1 && world.refuse(read.contestants.front()).empty() &&
                    key_of(world, read.contestants.front()) == mouse.identity();
  if (!same) return Presence::elsewhere;
  rename(read.contestants.front(), mouse.name);
  mouse = std::move(read.contestants.front());
  return Presence::here;
}

/// The contests of a race that are picked and can be run again; the others are counted.
std::vector<const ContestResult*> pick(Race& race, Rng& rng, const VerificationOrder& order, Permissions& permissions,
                                       Verification& found) {
  std::vector<const ContestResult*> picked;
  std::vector<std::optional<Presence>> presence(race.mice.size());
  constexpr int of = 1'000'000;
  for (const ContestResult& contest : race.results) {
    if (!rng.chance(static_cast<int>(order.share * of), of)) continue;
    std::optional<Presence>& mouse = presence[contest.mouse];
    if (!mouse) mouse = revive(race.world(), race.mice[contest.mouse], order, permissions);
    if (mouse == Presence::here) picked.push_back(&contest);
    found.impossible += mouse == Presence::elsewhere ? 1 : 0;
    found.not_run += mouse == Presence::not_to_be_run ? 1 : 0;
  }
  return picked;
}

/// All of a result but its timings, as text.
std::string text_of(const World& world, const ContestResult& result) {
  const StoredFigures& stored = world.traits().fields->figures;
  std::vector<Value> figures = stored.values_of(*result.figures);
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (stored.all[i].by_clock) figures[i] = Value();
  figures.insert(figures.end(), {value_of(result.score), value_of(result.counted), value_of(result.ratio),
                                 std::int64_t{result.outcome_order}, result.outcome, result.never_started});
  return figures_text(figures);
}

std::string words_of(const ContestResult& result) {
  return result.score ? fmt::format("{} ({})", result.outcome, *result.score) : result.outcome;
}

}  // namespace

Verification verify_store(const std::string& path, const StoreFilter& filter, const VerificationOrder& order) {
  Verification found;
  order.external_mice.hidden->add_store(path);
  StoredRaces stored = all_stored_contests(path, filter);
  found.remarks = std::move(stored.remarks);
  found.error = std::move(stored.error);
  Rng rng(order.seed);
  Permissions permissions(order, found);
  std::mutex noting;
  for (Race& race : stored.races) {
    const std::vector<const ContestResult*> picked = pick(race, rng, order, permissions, found);
    for_each_parallel(picked.size(), order.jobs, [&](std::size_t i) {
      if (order.stop != nullptr && order.stop->load()) {
        const std::lock_guard lock(noting);
        found.stopped = true;
        return;
      }
      const ContestResult& kept = *picked[i];
      ContestResult again;
      again.mouse = kept.mouse;
      again.maze = kept.maze;
      again.run = kept.run;
      again.seed = kept.seed;
      again.told = kept.told;
      race.world().hold(race, again, {}, order.stop);
      if (!again.done) {
        const std::lock_guard lock(noting);
        found.stopped = true;
        return;
      }
      if (!again.judged) return;
      const bool equal = text_of(race.world(), again) == text_of(race.world(), kept);
      const std::lock_guard lock(noting);
      ++found.held;
      found.equal += equal ? 1 : 0;
      if (!equal)
        found.differences.push_back(
            shown(fmt::format("{} in {} with seed {}: {} now, and {} in the store", race.mice[kept.mouse].name,
                              race.mazes[kept.maze].name, kept.seed, words_of(again), words_of(kept))));
    });
  }
  std::sort(found.differences.begin(), found.differences.end());
  return found;
}

}  // namespace labmouse
