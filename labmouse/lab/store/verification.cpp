#include "labmouse/lab/store/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "labmouse/chance/dice.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/store/contest_key.hpp"
#include "labmouse/lab/store/figures.hpp"
#include "labmouse/lab/system/parallel.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Puts the mice of the race in the place of their descriptions; false for those that are not here.
std::vector<bool> revive(Race& race, const GuestOptions& guests) {
  std::vector<bool> here;
  for (Contestant& mouse : race.mice) {
    SpecResult read = read_specs(spec_of(mouse), guests);
    const bool same = read.contestants.size() == 1 && race.world().refuse(read.contestants.front()).empty() &&
                      key_of(race.world(), read.contestants.front()) == mouse.identity();
    here.push_back(same);
    if (!same) continue;
    rename(read.contestants.front(), mouse.name);
    mouse = std::move(read.contestants.front());
  }
  return here;
}

/// All of a result but its timings, as text.
std::string text_of(const World& world, const ContestResult& result) {
  std::vector<Value> figures = result.figures;
  for (const Timing& timing : world.timings()) figures[timing.figure] = Value();
  figures.insert(figures.end(), {or_none(result.score), or_none(result.counted), or_none(result.ratio),
                                 std::int64_t{result.outcome_order}, result.outcome, result.never_started});
  return figures_text(figures);
}

std::string words_of(const ContestResult& result) {
  return result.score ? fmt::format("{} ({})", result.outcome, *result.score) : result.outcome;
}

}  // namespace

Verification verify_store(const std::string& path, const StoreFilter& filter, const VerificationOrder& order) {
  Verification found;
  StoredRaces stored = all_stored_contests(path, filter);
  found.remarks = std::move(stored.remarks);
  found.error = std::move(stored.error);
  Dice dice(order.seed);
  std::mutex noting;
  for (Race& race : stored.races) {
    const std::vector<bool> here = revive(race, order.guests);
    std::vector<const ContestResult*> picked;
    constexpr int of = 1'000'000;
    for (const ContestResult& contest : race.results) {
      if (!dice.chance(static_cast<int>(order.share * of), of)) continue;
      if (here[contest.mouse])
        picked.push_back(&contest);
      else
        ++found.impossible;
    }
    for_each_parallel(picked.size(), order.jobs, [&](std::size_t i) {
      if (order.stop != nullptr && order.stop->load()) return;
      const ContestResult& kept = *picked[i];
      ContestResult again;
      again.mouse = kept.mouse;
      again.maze = kept.maze;
      again.run = kept.run;
      again.seed = kept.seed;
      race.world().hold(race, again, {}, order.stop);
      if (!again.done) return;
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
