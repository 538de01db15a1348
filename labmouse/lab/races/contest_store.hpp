// Interface of stores, which keep contests so that none has to run twice. lab/store implements it as a file.
#pragma once

#include <functional>

namespace labmouse {

struct Race;
struct ContestResult;

/// Serves one race at a time.
class ContestStore {
 public:
  ContestStore() = default;
  ContestStore(const ContestStore&) = delete;
  ContestStore& operator=(const ContestStore&) = delete;
  virtual ~ContestStore() = default;

  /// Before any contest of a race runs: fills in the results that are in the store and `wanted`, and marks them as
  /// done.
  virtual void recall(Race& race, const std::function<bool(const ContestResult&)>& wanted) = 0;
  /// Stores a contest of that race after it has run. Called from several threads at once.
  virtual void keep(const Race& race, const ContestResult& contest) = 0;
  /// Whether it can keep no more: then no other contest begins.
  virtual bool failed() const = 0;
};

}  // namespace labmouse
