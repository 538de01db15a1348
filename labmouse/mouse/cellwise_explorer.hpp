// Base of strategies in seconds that follow the orders of a program that moves cell by cell, such as a program written
// for the world of steps or for mms: the controller drives what the program orders.
//
// The program and the mouse may be in different cells: after a crash the mouse is carried to the start, which such a
// program cannot know. Then the mouse first drives back to the program's cell, over known cells.
#pragma once

#include "labmouse/mouse/driving_explorer.hpp"

namespace labmouse {

/// Increased when the same orders are driven in another way: stores of contests then do not take the earlier results.
inline constexpr int driven_edition = 1;

class CellwiseExplorer : public DrivingExplorer {
 protected:
  /// For a briefing in seconds.
  explicit CellwiseExplorer(const Briefing& briefing);

  /// What the program orders next.
  struct Order {
    enum class Kind : std::uint8_t {
      move,     ///< `cells` cells in `direction`; 0: nothing that the mouse has to drive
      end,      ///< the end of the search: the way home, and the speed run
      forfeit,  ///< the end of the contest
    };
    Kind kind = Kind::move;
    Heading direction = Heading::north;
    int cells = 0;
    ForfeitReason reason = ForfeitReason::none;
  };
  /// Asks the program for its next order, once its last move has ended.
  virtual Order next_order() = 0;

  /// The cell of the program.
  Cell cell() const { return cell_; }
  /// Sets the cell of the program, to which the mouse then drives.
  void move_to(Cell cell) { cell_ = cell; }
  /// Whether a wall ended its last move early.
  bool was_blocked() const { return left_ > 0; }
  /// The state of a wall in the mouse's map; the border is closed.
  WallState state(Cell cell, Heading side) const;
  /// Whether its cell was a goal. Unlike goal_entered(), this stays true if the map changes.
  bool was_in_goal() const { return was_in_goal_; }

 private:
  Action explore() final;
  void settle();
  bool is_blocked() const;
  int cells_ahead() const;
  Action move();
  Action way_to(const CellSet& cells);
  Action end();

  Cell cell_;
  Heading direction_ = Heading::north;  ///< of its present move
  int left_ = 0;                        ///< cells that this move still has
  int asked_ = 0;                       ///< how many of them the last action asked for
  bool ended_ = false;                  ///< whether it has ended its search
  bool was_in_goal_;
  int tries_ = 0;  ///< actions in a row to leave the same cell
  int idle_ = 0;   ///< orders in a row without a move
};

}  // namespace labmouse
