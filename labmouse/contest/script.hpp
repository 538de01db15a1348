// A strategy that plays a fixed list of actions, for example those of a record.
#pragma once

#include <utility>
#include <vector>

#include "labmouse/mouse/driving_strategy.hpp"

namespace labmouse {

/// Plays its actions in order, then forfeits, in steps and in seconds. It ignores all readings.
class Script final : public DrivingStrategy {
 public:
  /// `paces` has the pace of each run; runs beyond the list have the usual pace.
  Script(Size size, std::vector<Action> actions, std::vector<double> paces = {})
      : knowledge_(size), actions_(std::move(actions)), paces_(std::move(paces)) {}

  Action decide(const Sighting&) override { return next(); }
  Action consider(const LogOddsMap&, const SearchPlace&, std::int64_t) override { return next(); }
  void show(const Pose&, const Sighting&) override {}
  void carried(std::int64_t) override {}
  double pace(bool) override { return run_ < paces_.size() ? paces_[run_++] : 1.0; }
  const Knowledge& knowledge() const override { return knowledge_; }

 private:
  Action next() { return next_ < actions_.size() ? actions_[next_++] : Action::forfeit(ForfeitReason::finished); }

  Knowledge knowledge_;
  std::vector<Action> actions_;
  std::size_t next_ = 0;
  std::vector<double> paces_;
  std::size_t run_ = 0;
};

}  // namespace labmouse
