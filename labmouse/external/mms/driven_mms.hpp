// A program for mms that drives in seconds. The simulator answers it from the mouse's map, and the controller drives
// the moves, cell by cell. The way home and the speed run are those of the contest.
#pragma once

#include <string>

#include "labmouse/external/mms/host.hpp"
#include "labmouse/external/talk.hpp"
#include "labmouse/mouse/cellwise_explorer.hpp"

namespace labmouse {

/// Its search ends when the program ends, is back at the start, writes ackReset or does nothing any more, each time
/// after it has entered a goal. Turns are driven with the next move. A move must begin and end in the middle of a cell,
/// and lead through a side of it. Walls that the mouse has not seen count as open.
class DrivenMms final : public CellwiseExplorer {
 public:
  /// Starts the program. `briefing`: in seconds.
  DrivenMms(const Launch& launch, const Briefing& briefing);

  StrategyReport report() override;

 private:
  Order next_order() override;
  void settle_move();
  std::optional<Order> order_of(const HalfPose& before, bool reset);
  Order end_search(ForfeitReason reason, std::string_view sentence);

  ExternalTalk talk_;
  MmsHost host_;
  std::string replies_;         ///< to its last line; sent with the next question for a line
  bool begun_ = false;          ///< whether it has written a line
  bool moves_ = false;          ///< whether its last line was a move
  std::int64_t last_move_ = 0;  ///< number of that line
};

}  // namespace labmouse
