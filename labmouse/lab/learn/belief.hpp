// Observation planes for learning: what a mouse knows of each cell, in sixteen bits.
//
//      bit  0.. 3   the wall to the north, east, south, west is known to be open
//      bit  4.. 7   ... is known to be closed; a wall with neither bit has not been seen
//      bit  8       the mouse stood in the cell or passed through it
//      bit  9..12   the mouse stands here, heading north, east, south, west
//      bit 13       the cell is a goal
//      bit 14       this is the speed run (in every cell of the maze)
//      bit 15       a goal was entered, so a reset begins the speed run (in every cell of the maze)
//
// A wall is known from both of its cells. In a batch of mazes of several sizes, cells outside of a smaller maze have
// all bits 0. A cell is stored as one word, or as sixteen bytes of 0 or 1, bit 0 first.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "labmouse/grid/heading.hpp"

namespace labmouse {

inline constexpr int belief_planes = 16;

using BeliefBits = std::uint16_t;

constexpr BeliefBits open_bit(Heading side) { return static_cast<BeliefBits>(1U << static_cast<unsigned>(side)); }
constexpr BeliefBits closed_bit(Heading side) { return static_cast<BeliefBits>(16U << static_cast<unsigned>(side)); }
inline constexpr BeliefBits visited_bit = 1U << 8U;
constexpr BeliefBits pose_bit(Heading heading) {
  return static_cast<BeliefBits>(1U << 9U << static_cast<unsigned>(heading));
}
inline constexpr BeliefBits goal_bit = 1U << 13U;
inline constexpr BeliefBits speed_run_bit = 1U << 14U;
inline constexpr BeliefBits goal_entered_bit = 1U << 15U;

/// A cell's bits as one word.
struct BeliefWord {
  using Unit = std::uint16_t;
  static constexpr int units_a_cell = 1;

  static void add(Unit* cell, BeliefBits bits) { *cell = static_cast<Unit>(*cell | bits); }
  static void remove(Unit* cell, BeliefBits bits) { *cell = static_cast<Unit>(*cell & ~bits); }
};

/// A cell's bits as sixteen bytes of 0 or 1.
struct BeliefBytes {
  using Unit = std::uint8_t;
  static constexpr int units_a_cell = belief_planes;

  static void add(Unit* cell, BeliefBits bits) {
    change(cell, bits, [](std::uint64_t bytes, std::uint64_t ones) { return bytes | ones; });
  }
  static void remove(Unit* cell, BeliefBits bits) {
    change(cell, bits, [](std::uint64_t bytes, std::uint64_t ones) { return bytes & ~ones; });
  }

 private:
  // Expands eight bits to eight bytes, bit 0 first in memory.
  static constexpr std::array<std::uint64_t, 256> spread = [] {
    std::array<std::uint64_t, 256> table{};
    for (unsigned bits = 0; bits < 256; ++bits)
      for (unsigned bit = 0; bit < 8; ++bit)
        if ((bits >> bit & 1U) != 0) table[bits] |= std::uint64_t{1} << (8 * bit);
    return table;
  }();

  template <class Change>
  static void change(Unit* cell, BeliefBits bits, Change change) {
    std::array<std::uint64_t, 2> bytes;
    std::memcpy(bytes.data(), cell, sizeof bytes);
    bytes[0] = change(bytes[0], spread[bits & 255U]);
    bytes[1] = change(bytes[1], spread[bits >> 8U]);
    std::memcpy(cell, bytes.data(), sizeof bytes);
  }
};

}  // namespace labmouse
