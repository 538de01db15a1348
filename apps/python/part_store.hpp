// Stores that limit which contests a race runs, for a machine that does a part of the work, or none of it.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "errors.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/store/store.hpp"

namespace labmouse::python {

/// The name of a mouse, that of a maze, and the number of the run.
using PickedContest = std::tuple<std::string, std::string, int>;
/// No value means all contests.
using PickedContests = std::optional<std::vector<PickedContest>>;

/// The path of a store, or empty; the contests to run if the store does not have them; and the use of the store: "keep"
/// stores new contests, "read" only reads and runs none, "send" is a temporary file, whose writes do not wait for the
/// disk.
using GivenStore = std::tuple<std::string, PickedContests, std::string>;

/// Runs only the picked contests: it marks all others as done, so that the race skips them. The race's own results for
/// those are meaningless; read the results from the store.
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

  /// Contests that were neither picked nor in the store. Valid once the race has ended.
  const std::vector<PickedContest>& missing() const { return missing_; }

 private:
  std::shared_ptr<ContestStore> store_;
  std::set<PickedContest> picked_;
  std::vector<PickedContest> missing_;
};

/// Recalls what a store has, and reports a failure so that the race runs no contest.
class ReadStore final : public ContestStore {
 public:
  explicit ReadStore(std::shared_ptr<ContestStore> store) : store_(std::move(store)) {}

  void recall(Race& race, const std::function<bool(const ContestResult&)>& wanted) override {
    store_->recall(race, wanted);
  }
  void keep(const Race&, const ContestResult&) override {}
  bool failed() const override { return true; }

 private:
  std::shared_ptr<ContestStore> store_;
};

/// Opens the store of a race and closes it.
class RaceStore {
 public:
  /// Throws UserError.
  explicit RaceStore(const GivenStore& given) {
    const auto& [path, picked, use] = given;
    if (path.empty()) return;
    store_ = std::make_shared<Store>(path, use == "send" ? Database::Access::scratch : Database::Access::create);
    if (store_->failed()) throw UserError(store_->finish());
    shown_ = store_;
    if (picked) shown_ = part_ = std::make_shared<PartStore>(shown_, *picked);
    if (use == "read") shown_ = std::make_shared<ReadStore>(shown_);
  }

  /// The store to give to the race; null if there is none.
  const std::shared_ptr<ContestStore>& shown() const { return shown_; }

  /// Call once the race has ended. Waits until all contests are on the disk and closes the store. Returns how many
  /// contests came from it; 0 in later calls. Throws UserError.
  std::size_t finish() {
    shown_.reset();
    if (!store_) return 0;
    const std::shared_ptr<Store> finished = std::move(store_);
    if (const std::string error = finished->finish(); !error.empty()) throw UserError(error);
    return finished->recalled();
  }
  /// See PartStore::missing.
  std::vector<PickedContest> missing() const { return part_ ? part_->missing() : std::vector<PickedContest>(); }

 private:
  std::shared_ptr<Store> store_;
  std::shared_ptr<PartStore> part_;
  std::shared_ptr<ContestStore> shown_;
};

}  // namespace labmouse::python
