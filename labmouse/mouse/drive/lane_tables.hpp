// The tables of a robot with several speeds, in the layout of its search: rows of lanes, several of which are processed
// at once.
//
// At each kind of node - edges, middles of cells, diagonals - turns end and begin only in some of the lanes. These are
// its slots, which lie side by side in a row.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "labmouse/mouse/drive/vectors.hpp"
#include "labmouse/mouse/robot/tables.hpp"

namespace labmouse::drive {

enum NodeKind : unsigned { edge_node, centre_node, diagonal_node };
inline constexpr unsigned node_kinds = 3;

/// Each kind of node has three slots for each speed of turns, one behind the other in memory. Centres have four turns,
/// so their row reaches into the first slots of the next node in memory. That is an edge, which has only one turn and
/// leaves these slots free. The times of unused slots are no_time.
inline constexpr unsigned slots_a_speed = 3;
inline constexpr std::array<unsigned, node_kinds> first_slot_a_speed = {1, 0, 0}, end_slot_a_speed = {3, 4, 3};

/// The length of a row in the tables, filled up to whole vectors.
constexpr unsigned row_of(unsigned kind, unsigned speeds) {
  return (end_slot_a_speed[kind] * speeds + width - 1) / width * width;
}

/// A turn that ends in a slot of a kind of node: that slot, its bit (at the reversed node), the slot in which it began,
/// and its time. If it may begin in several slots, the entries of the others follow.
struct TurnBefore {
  std::uint8_t slot = 0;
  std::uint8_t bit = 0;
  std::uint8_t before = 0;
  bool more = false;
  DriveTime time = 0;
};

/// The same robot driven backwards.
DriveTables backwards(const DriveTables& tables);

/// The least number of speeds (1, 2, 4, 6 or 8) with enough slots for the turns; 0 if more than 8 would be needed.
unsigned speeds_for(const DriveTables& tables);

class LaneTables {
 public:
  /// For at least as many speeds as the tables need.
  LaneTables(const DriveTables& tables, unsigned speeds);

  static constexpr int no_slot = -1;

  int slot(unsigned kind, std::size_t lane) const { return slots_[kind][lane]; }

  /// The times of straights to a turn that begins in a slot: a row for each number of units, by the slot that they come
  /// from. Rows of straights along the axes are all as long as those of centres.
  const DriveTime* straights(unsigned kind, unsigned slot) const { return at(straights_, kind, slot, lengths); }
  /// The same for straights into the middle of a goal, with `room` open cells beyond it to stop in.
  const DriveTime* finish(int room) const {
    return &finish_[static_cast<std::size_t>(std::min(room, rooms_ - 1)) * lengths * row(centre_node)];
  }

  /// A test of dominance. Another turn begins 0, 2, 4, 8 ... units ahead in the search. If its time is later than that
  /// of a turn in this slot by no more than its entry here, it is as good for all places `reach` units or more beyond
  /// it. A row for each distance, by the slots of the other turn. Entries at 0 units are less by one, so that two turns
  /// never exclude each other.
  const DriveTime* slacks(unsigned kind, unsigned slot) const { return at(slacks_, kind, slot, checks); }
  static constexpr int checks = 6;
  int reach() const { return reach_; }

  /// The turns that end at a kind of node, by number: one for each slot and bit, the first of those that agree in both.
  /// turns() gives those numbers as bits that end in one of the slots and have one of the bits.
  const TurnBefore* turn(unsigned kind, unsigned number) const { return &turns_[kind][first_turn_[kind][number]]; }
  template <class Slots>
  std::uint64_t turns(unsigned kind, Slots slots, unsigned bits) const {
    std::uint64_t ending = 0;
    for (unsigned byte = 0; byte < sizeof(Slots); ++byte) ending |= ending_in_[kind][byte][slots >> 8 * byte & 255U];
    return ending & beginning_with_[kind][bits];
  }
  static constexpr unsigned most_turns = 64;

  std::size_t bytes() const;

 private:
  static constexpr int lengths = StraightTimes::longest + 1;

  std::size_t row(unsigned kind) const { return row_of(kind == edge_node ? centre_node : kind, speeds_); }
  std::size_t place(unsigned kind, unsigned slot, int rows) const {
    return first_row_[kind] * static_cast<std::size_t>(rows) + slot * static_cast<std::size_t>(rows) * row(kind);
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
  struct Slot {
    unsigned number;
    std::size_t lane;
  };
  void add_turns(const DriveTables& tables, unsigned kind, unsigned bit, const Slot& slot);

  unsigned speeds_;
  int rooms_ = 1;
  int reach_ = 1;
  std::array<std::size_t, node_kinds + 1> first_row_{};  ///< count of numbers in the rows of earlier kinds
  std::array<std::vector<int>, node_kinds> slots_;       ///< by lane
  std::array<std::vector<Slot>, node_kinds> used_;
  std::vector<DriveTime> straights_;
  std::vector<DriveTime> finish_;
  std::vector<DriveTime> slacks_;
  std::array<std::vector<TurnBefore>, node_kinds> turns_;
  std::array<std::array<std::uint16_t, most_turns>, node_kinds> first_turn_{};
  std::array<std::array<std::array<std::uint64_t, 256>, 4>, node_kinds> ending_in_{};  ///< by slots, in groups of eight
  std::array<std::array<std::uint64_t, 256>, node_kinds> beginning_with_{};            ///< by bits
};

}  // namespace labmouse::drive
