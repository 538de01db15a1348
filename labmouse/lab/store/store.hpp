// A file of contests: stored contests are not run again, and new ones are written to disk in batches. See
// docs/how-to/clusters-and-stores.md.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "labmouse/lab/races/contest_store.hpp"
#include "labmouse/lab/store/contest_rows.hpp"
#include "labmouse/lab/store/database.hpp"

namespace labmouse {

/// Other programs may read and write the same file at the same time.
class Store final : public ContestStore {
 public:
  /// Opens the file or creates it; finish() reports errors. With Access::scratch, writes do not wait for the disk.
  explicit Store(const std::string& path, Database::Access access = Database::Access::create);
  /// Writes the remaining contests. Call finish() before to learn whether that worked.
  ~Store() override;

  void recall(Race& race, const std::function<bool(const ContestResult&)>& wanted) override;
  void keep(const Race& race, const ContestResult& contest) override;
  bool failed() const override { return failed_.load(std::memory_order_relaxed); }

  /// Waits until all contests are on the disk. Returns the first error as a line for the user, "results.db: error:
  /// ...", or nothing. Call it between races, and before the counters below.
  std::string finish();

  std::size_t recalled() const { return recalled_; }  ///< contests that were not run, because they were stored
  std::size_t added() const { return added_; }        ///< contests that were new in the store
  /// Contests that were run but not stored, because their mouse cannot be identified later.
  std::size_t passed_by() const { return passed_by_; }
  const std::string& path() const { return path_; }

 private:
  void write_batches();
  void write_or_fail(std::span<const ContestRow> rows);
  void write(std::span<const ContestRow> rows);

  std::string path_;
  Database writing_;                      ///< for the writer; opened first, because it creates the file
  Database reading_;                      ///< for the thread that starts a race
  std::shared_ptr<const RaceRows> rows_;  ///< of the current race
  std::atomic<std::size_t> recalled_{0}, added_{0}, passed_by_{0};
  std::atomic<bool> failed_{false};

  std::mutex mutex_;  ///< protects all members below
  std::condition_variable work_, done_;
  std::vector<ContestRow> waiting_;
  bool writing_now_ = false, closing_ = false, hurry_ = false;
  std::thread writer_;  // last, because it uses all other members
};

}  // namespace labmouse
