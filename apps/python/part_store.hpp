// A store that lets a race hold only some of its contests, for a machine that does a part of the work.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/store/store.hpp"

namespace labmouse::python {

/// The name of a mouse, that of a maze, and the number of the run.
using PickedContest = std::tuple<std::string, std::string, int>;
/// Nothing where all contests are meant.
using PickedContests = std::optional<std::vector<PickedContest>>;

/// Says that all other contests are done, so that none of them is held. What a race says of those has no meaning: only
/// the store is to be read.
class PartStore final : public ContestStore {
 public:
  PartStore(std::shared_ptr<ContestStore> store, const std::vector<PickedContest>& picked)
      : store_(std::move(store)), picked_(picked.begin(), picked.end()) {}

  void recall(Race& race, const std::function<bool(const ContestResult&)>& wanted) override {
    store_->recall(race, wanted);
    for (ContestResult& contest : race.results) {
      PickedContest name(race.mice[contest.mouse].name, race.mazes[contest.maze].name, contest.run);
      if (contest.done || picked_.count(name) > 0) continue;
      missing_.push_back(std::move(name));
      contest.done = true;
    }
  }
  void keep(const Race& race, const ContestResult& contest) override { store_->keep(race, contest); }
  bool failed() const override { return store_->failed(); }

  /// Contests that were not picked and are not in the store, once the race has ended.
  const std::vector<PickedContest>& missing() const { return missing_; }

 private:
  std::shared_ptr<ContestStore> store_;
  std::set<PickedContest> picked_;
  std::vector<PickedContest> missing_;
};

/// The store through which a race sees those contests alone; null where all are meant.
inline std::shared_ptr<PartStore> part_of(const std::shared_ptr<Store>& store, const PickedContests& picked) {
  return store && picked ? std::make_shared<PartStore>(store, *picked) : nullptr;
}

/// As of PartStore.
inline std::vector<PickedContest> missing_of(const std::shared_ptr<PartStore>& part) {
  return part ? part->missing() : std::vector<PickedContest>();
}

}  // namespace labmouse::python
