// A store of contests in a file: what is there is not run again, and what is held is there when its batch is on the
// disk. docs/how-to/clusters-and-stores.md describes it to people.
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
  /// Opens the file, or makes it; finish() says what is wrong with it. With Access::scratch nothing waits for the disk.
  explicit Store(const std::string& path, Database::Access access = Database::Access::create);
  /// Writes what is left; asked before, finish() says whether that worked.
  ~Store() override;

  void recall(Race& race, const std::function<bool(const ContestResult&)>& wanted) override;
  void keep(const Race& race, const ContestResult& contest) override;
  bool failed() const override { return failed_.load(std::memory_order_relaxed); }

  /// Waits until all that it was given is on the disk. Returns what went wrong, now or before, as a line for the user:
  /// "results.db: error: ..."; or nothing. To be called between races, and before the other figures are asked for.
  std::string finish();

  std::size_t recalled() const { return recalled_; }  ///< contests that were not held, because they were there
  std::size_t added() const { return added_; }        ///< contests that are there now and were not before
  /// Contests of mice of which nothing is known that could be compared later: they were held and not kept.
  std::size_t passed_by() const { return passed_by_; }
  const std::string& path() const { return path_; }

 private:
  void write_batches();
  void write_or_fail(std::span<const ContestRow> rows);
  void write(std::span<const ContestRow> rows);

  std::string path_;
  Database writing_;                      ///< for the writer; before the other, because it makes the file
  Database reading_;                      ///< for the thread that begins a race
  std::shared_ptr<const RaceRows> rows_;  ///< of the present race
  std::atomic<std::size_t> recalled_{0}, added_{0}, passed_by_{0};
  std::atomic<bool> failed_{false};

  std::mutex mutex_;  ///< of all below
  std::condition_variable work_, done_;
  std::vector<ContestRow> waiting_;
  bool writing_now_ = false, closing_ = false, hurry_ = false;
  std::thread writer_;  // last: it uses all others
};

}  // namespace labmouse
