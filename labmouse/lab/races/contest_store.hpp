// Where contests are kept, so that none has to be held twice. lab/store has the one in a file.
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

  /// Before any contest of a race is held: fills in those that were kept before and are `wanted`, which are done then.
  virtual void recall(Race& race, const std::function<bool(const ContestResult&)>& wanted) = 0;
  /// Takes a contest of that race that was held. From several threads at once.
  virtual void keep(const Race& race, const ContestResult& contest) = 0;
  /// Whether it can keep no more: then no other contest begins.
  virtual bool failed() const = 0;
};

}  // namespace labmouse
