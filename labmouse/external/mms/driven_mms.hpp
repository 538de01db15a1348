// A program for mms that drives in seconds: the controller drives what it orders, cell by cell, and its questions are
// answered from the mouse's map. The way home and the speed run are those of the contest.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/external/mms/command.hpp"
#include "labmouse/external/mms/statistics.hpp"
#include "labmouse/external/talk.hpp"
#include "labmouse/mouse/cellwise_explorer.hpp"

namespace labmouse {

/// Its search ends when it ends itself, when it is back at the start, when it calls ackReset, or when it does nothing
/// any more but wait for Reset, each time after it has entered a goal. Turns are driven with the next move. It must not
/// move by half cells or turn by 45 degrees. A wall that the mouse has not seen is answered as open.
class DrivenMms final : public CellwiseExplorer {
 public:
  /// Starts the program. `briefing`: in seconds.
  DrivenMms(const Launch& launch, const Briefing& briefing);

  StrategyReport report() override;

 private:
  Order next_order() override;
  /// Obeys a command. Returns an order if the mouse has to drive, or the contest or the search ends.
  std::optional<Order> obey(const MmsCommand& command);
  std::optional<Order> move(std::int64_t half_steps);
  std::optional<Order> turn(int eighths);
  bool sees_wall(Heading direction, std::int64_t half_steps) const;
  void arrive();
  Order end_search(ForfeitReason reason);
  Order refuse(std::string_view what);

  ExternalTalk talk_;
  MmsLedger ledger_;
  std::string reply_;  ///< to its last command; sent with the next question for a line
  Heading heading_;
  bool moves_ = false;  ///< whether its last command was a move, which needs a reply
  bool begun_ = false;  ///< whether it has written a line
  int lines_ = 0;       ///< in a row without a move
  int questions_ = 0;   ///< `wasReset` in a row
};

}  // namespace labmouse
