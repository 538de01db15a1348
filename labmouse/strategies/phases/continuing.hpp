// The second phase of `phases`: exploration between the first goal and the reset.
#pragma once

#include <memory>
#include <optional>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/strategies/parameter.hpp"
#include "labmouse/strategies/phases/searching.hpp"

namespace labmouse {

class Continuing {
 public:
  virtual ~Continuing() = default;
  /// The next action, for a pose whose reading has been learned; nullopt when it is time for the reset. `visited` are
  /// the cells in which the mouse has stood.
  virtual std::optional<Action> next(const Knowledge& knowledge, Pose pose, const CellSet& visited) = 0;
};

/// The method of the parameter `continuing`. It may use `searching`, which must outlive it.
std::unique_ptr<Continuing> make_continuing(const Briefing& briefing, const Settings& settings, Searching& searching);

}  // namespace labmouse
