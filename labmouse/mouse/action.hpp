// What a mouse can do.
#pragma once

#include <cstdint>
#include <string_view>

namespace labmouse {

/// Why a mouse gives up: its last word in place of an exception.
enum class ForfeitReason : std::uint8_t {
  none,
  contradiction,  ///< a reading contradicts what was read before
  no_way,         ///< no route that could exist leads to a goal
  lost,           ///< the mouse no longer knows where it stands
  finished,       ///< a prepared list of actions has no more
};

constexpr std::string_view name_of(ForfeitReason reason) {
  switch (reason) {
    case ForfeitReason::none: return "none";
    case ForfeitReason::contradiction: return "contradiction";
    case ForfeitReason::no_way: return "no way";
    case ForfeitReason::lost: return "lost";
    case ForfeitReason::finished: return "finished";
  }
  return "unknown";
}

/// One decision: a step, a reset (back to the start, for the speed run) or a forfeit.
struct Action {
  enum class Kind : std::uint8_t { step, reset, forfeit };

  Kind kind = Kind::step;
  /// Degrees clockwise; the world turns by -90, 0 or 90 and does not perform any other value.
  int rotation = 0;
  /// Cells to go after the turn, negative backwards; the world cuts it to its longest stride.
  int movement = 0;
  ForfeitReason reason = ForfeitReason::none;

  static constexpr Action step(int rotation, int movement) {
    return {Kind::step, rotation, movement, ForfeitReason::none};
  }
  static constexpr Action reset() { return {Kind::reset, 0, 0, ForfeitReason::none}; }
  static constexpr Action forfeit(ForfeitReason reason) { return {Kind::forfeit, 0, 0, reason}; }

  friend constexpr bool operator==(const Action&, const Action&) = default;
};

}  // namespace labmouse
