// The tables of a robot of many speeds as its search uses them: rows of lanes, several of which are looked at together.
//
// At each kind of node - edges, middles of cells, diagonals - turns end and begin only in some of the lanes. These are
// its slots, which a row has side by side.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "labmouse/mouse/drive/vectors.hpp"
#include "labmouse/mouse/robot/tables.hpp"

namespace labmouse::drive {

/// The slots of a row, more than any robot needs: four turns at two speeds. The times of those that a kind of node has
/// not are no_time.
inline constexpr unsigned row = 8;

enum NodeKind : unsigned { edge_node, centre_node, diagonal_node };
inline constexpr unsigned node_kinds = 3;

/// A turn that ends at a kind of node: the slot in which it does, its bit (of the node turned round), the slot in which
/// it began, and its time.
struct TurnBefore {
  std::uint8_t slot = 0;
  std::uint8_t bit = 0;
  std::uint8_t before = 0;
  DriveTime time = 0;
};

/// The same robot driven backwards.
DriveTables backwards(const DriveTables& tables);

class LaneTables {
 public:
  explicit LaneTables(const DriveTables& tables);

  static constexpr int no_slot = -1;
  static constexpr unsigned most_turns = 32;

  int slot(unsigned kind, std::size_t lane) const { return slots_[kind][lane]; }

  /// The times of straights to a turn that begins in a slot: rows of the slots that they come from, by units.
  const DriveTime* straights(unsigned kind, unsigned slot) const { return at(straights_, kind, slot, lengths); }
  /// The same of straights into the middle of a goal.
  const DriveTime* finish() const { return finish_.data(); }

  /// How much later a mouse may begin a turn in a slot than another one begins a turn 0, 2, 4, 8 ... units before, and
  /// be nowhere ahead of it that is `reach` units or more before that: rows of the other one's slots. A turn in the
  /// same place must be later by one more, so that no two say so of each other.
  const DriveTime* slacks(unsigned kind, unsigned slot) const { return at(slacks_, kind, slot, checks); }
  static constexpr int checks = 6;
  int reach() const { return reach_; }

  /// The turns that end at a kind of node, by number, and of them as bits those that end in some slots and have a bit.
  const TurnBefore& turn(unsigned kind, unsigned number) const { return turns_[kind][number]; }
  unsigned turns(unsigned kind, unsigned slots, unsigned bits) const {
    return ending_in_[kind][slots] & beginning_with_[kind][bits];
  }

 private:
  static constexpr int lengths = StraightTimes::longest + 1;

  std::size_t place(unsigned kind, unsigned slot, int rows) const {
    return (kind * static_cast<std::size_t>(row) + slot) * static_cast<std::size_t>(rows * row);
  }
  const DriveTime* at(const std::vector<DriveTime>& rows, unsigned kind, unsigned slot, int count) const {
    return &rows[place(kind, slot, count)];
  }
  void find_slots(const DriveTables& tables);
  void find_straights(const DriveTables& tables);
  void find_reach();
  void find_slacks();
  DriveTime slack(unsigned kind, unsigned slot, int units, unsigned other) const;
  void find_turns(const DriveTables& tables);

  int reach_ = 1;
  std::array<std::vector<int>, node_kinds> slots_;          ///< by lane
  std::array<std::vector<std::size_t>, node_kinds> lanes_;  ///< by slot
  std::vector<DriveTime> straights_;
  std::vector<DriveTime> finish_;
  std::vector<DriveTime> slacks_;
  std::array<std::array<TurnBefore, most_turns>, node_kinds> turns_{};
  std::array<std::array<unsigned, 256>, node_kinds> ending_in_{}, beginning_with_{};
};

}  // namespace labmouse::drive
