// The turns that a mouse can drive, and where each of them leads.
//
// Names are those of the builders: 45 and 135 lead from the middle of a cell onto a diagonal, and `out` back from it;
// 90 and 180 lead from cell to cell; V90 from diagonal to diagonal; S90 is the small turn of a search, from edge to
// edge inside one cell. All are written for a turn to the left; those to the right are their mirror images.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace labmouse {

/// A kind of turn. Those that begin with `f` begin at the middle of a cell; see above.
enum class Turn : std::uint8_t { f45, f90, f135, f180, v90, s90, out45, out135 };

/// All kinds, in the order of the enumeration.
inline constexpr std::array all_turns = {Turn::f45, Turn::f90, Turn::f135,  Turn::f180,
                                         Turn::v90, Turn::s90, Turn::out45, Turn::out135};

/// The name of a turn as builders write it.
/// @param turn one of all_turns.
/// @return the same for a turn onto a diagonal and the one back from it; in static memory.
constexpr std::string_view name_of(Turn turn) {
  constexpr std::array<std::string_view, 8> names = {"45", "90", "135", "180", "V90", "S90", "45", "135"};
  return names[static_cast<unsigned>(turn)];
}

/// Whether the straight before a turn is a diagonal.
/// @param turn one of all_turns.
constexpr bool begins_diagonal(Turn turn) { return turn == Turn::v90 || turn == Turn::out45 || turn == Turn::out135; }
/// Whether the straight after a turn is a diagonal.
/// @param turn one of all_turns.
constexpr bool ends_diagonal(Turn turn) { return turn == Turn::v90 || turn == Turn::f45 || turn == Turn::f135; }

/// The turn that is the same curve driven backwards.
/// @param turn one of all_turns.
/// @return the turn itself, unless it leads onto a diagonal or back from one.
constexpr Turn reversed(Turn turn) {
  switch (turn) {
    case Turn::f45:
      return Turn::out45;
    case Turn::f135:
      return Turn::out135;
    case Turn::out45:
      return Turn::f45;
    case Turn::out135:
      return Turn::f135;
    default:
      return turn;
  }
}

/// The angle of a turn.
/// @param turn one of all_turns.
/// @return eighths of a full circle, 1 to 4.
constexpr int eighths(Turn turn) {
  constexpr std::array<int, 8> angles = {1, 2, 3, 4, 2, 2, 1, 3};
  return angles[static_cast<unsigned>(turn)];
}

}  // namespace labmouse
