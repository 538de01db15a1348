// The first phase of `phases`: the way to a goal.
#pragma once

#include <memory>
#include <optional>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

class Searching {
 public:
  virtual ~Searching() = default;
  /// The next action, for a pose whose reading has been learned; nullopt if every reachable cell is explored and none
  /// is a goal.
  virtual std::optional<Action> next(const Knowledge& knowledge, Pose pose) = 0;
};

/// The method of the parameter `searching`.
std::unique_ptr<Searching> make_searching(const Briefing& briefing, const Settings& settings);

/// Whether that method is stochastic.
bool searches_by_chance(const Settings& settings);

}  // namespace labmouse
