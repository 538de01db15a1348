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

enum NodeKind : unsigned { edge_node, centre_node, diagonal_node };
inline constexpr unsigned node_kinds = 3;

/// Slots that nodes have for each speed of turns, one behind the other in memory: three each. Centres have four turns
/// and use the first slots of the edge behind them, too, which has one turn only and leaves them free. The times of
/// slots that a robot has not are no_time.
inline constexpr unsigned slots_a_speed = 3;
inline constexpr std::array<unsigned, node_kinds> first_slot_a_speed = {1, 0, 0}, end_slot_a_speed = {3, 4, 3};

/// Rows of tables are filled up to whole vectors.
constexpr unsigned row_of(unsigned kind, unsigned speeds) {
  return (end_slot_a_speed[kind] * speeds + width - 1) / width * width;
}

/// A turn that ends in a slot of a kind of node: the slot, its bit (of the node turned round), the slot in which it
/// began, and its time. Where it may begin in several, the next ones follow.
struct TurnBefore {
  std::uint8_t slot = 0;
  std::uint8_t bit = 0;
  std::uint8_t before = 0;
  bool more = false;
  DriveTime time = 0;
};

/// The same robot driven backwards.
DriveTables backwards(const DriveTables& tables);

/// The most speeds of a turn for which slots suffice: 1, 2, 4, 6 or 8, and 0 where more than 8 would be needed.
unsigned speeds_for(const DriveTables& tables);

class LaneTables {
 public:
  /// For at least as many speeds as the tables need.
  LaneTables(const DriveTables& tables, unsigned speeds);

  static constexpr int no_slot = -1;

  int slot(unsigned kind, std::size_t lane) const { return slots_[kind][lane]; }

  /// The times of straights to a turn that begins in a slot: rows of the slots that they come from, by units. Rows of
  /// straights along the axes are all as long as those of centres.
  const DriveTime* straights(unsigned kind, unsigned slot) const { return at(straights_, kind, slot, lengths); }
  /// The same of straights into the middle of a goal, where the mouse has so many cells to stop behind it.
  const DriveTime* finish(int room) const {
    return &finish_[static_cast<std::size_t>(std::min(room, rooms_ - 1)) * lengths * row(centre_node)];
  }

  /// How much later a mouse may begin a turn in a slot than another one begins a turn 0, 2, 4, 8 ... units before, and
  /// be nowhere ahead of it that is `reach` units or more before that: rows of the other one's slots. A turn in the
  /// same place must be later by one more, so that no two say so of each other.
  const DriveTime* slacks(unsigned kind, unsigned slot) const { return at(slacks_, kind, slot, checks); }
  static constexpr int checks = 6;
  int reach() const { return reach_; }

  /// The turns that end at a kind of node, by number: one for each slot and bit, the first of those that agree in both.
  /// As bits those that end in some slots and have a bit.
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
  std::array<std::size_t, node_kinds + 1> first_row_{};  ///< numbers in all rows of the kinds before
  std::array<std::vector<int>, node_kinds> slots_;       ///< by lane
  std::array<std::vector<Slot>, node_kinds> used_;
  std::vector<DriveTime> straights_;
  std::vector<DriveTime> finish_;
  std::vector<DriveTime> slacks_;
  std::array<std::vector<TurnBefore>, node_kinds> turns_;
  std::array<std::array<std::uint16_t, most_turns>, node_kinds> first_turn_{};
  std::array<std::array<std::array<std::uint64_t, 256>, 4>, node_kinds> ending_in_{};  ///< by slots, eight and eight
  std::array<std::array<std::uint64_t, 256>, node_kinds> beginning_with_{};            ///< by bits
};

}  // namespace labmouse::drive
