// The actions of a mouse, and the reasons for giving up.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace labmouse {

/// Why a mouse forfeits, or why an external mouse (a mouse that is another program) was stopped. Used in place of
/// exceptions.
enum class ForfeitReason : std::uint8_t {
  none,
  contradiction,       ///< a reading contradicts what was read before
  no_route,            ///< no possible route leads to a goal
  lost,                ///< the mouse no longer knows where it stands
  finished,            ///< a prepared list of actions has ended
  gave_up,             ///< the external mouse said so
  not_started,         ///< the external mouse could not be started
  ended_early,         ///< the external mouse ended before the contest did
  left,                ///< the external mouse ended, but a process that it started kept its output open
  closed,              ///< the external mouse ran on, but closed its input or its output
  hung,                ///< the external mouse did not answer
  late,                ///< the external mouse answered after its time limit for a decision
  out_of_time,         ///< the external mouse used up its time for the contest
  too_many_processes,  ///< the external mouse started too many processes
  too_much_memory,     ///< the external mouse and its processes used too much memory
  too_much_written,    ///< the external mouse and its processes wrote too much
  flooded,             ///< the external mouse sent more than it was asked for
  invalid_answer,      ///< the external mouse sent an invalid answer
  interrupted,         ///< the external mouse was stopped from outside
  not_judged,          ///< the machine was too busy to tell whether the external mouse was slow
};

/// All reasons, in the order of the enumeration.
inline constexpr std::array all_forfeit_reasons = {ForfeitReason::none,
                                                   ForfeitReason::contradiction,
                                                   ForfeitReason::no_route,
                                                   ForfeitReason::lost,
                                                   ForfeitReason::finished,
                                                   ForfeitReason::gave_up,
                                                   ForfeitReason::not_started,
                                                   ForfeitReason::ended_early,
                                                   ForfeitReason::left,
                                                   ForfeitReason::closed,
                                                   ForfeitReason::hung,
                                                   ForfeitReason::late,
                                                   ForfeitReason::out_of_time,
                                                   ForfeitReason::too_many_processes,
                                                   ForfeitReason::too_much_memory,
                                                   ForfeitReason::too_much_written,
                                                   ForfeitReason::flooded,
                                                   ForfeitReason::invalid_answer,
                                                   ForfeitReason::interrupted,
                                                   ForfeitReason::not_judged};

/// The name of a reason in messages and records.
/// @param reason one of the enumeration.
/// @return in lower case, with spaces: "no route".
constexpr std::string_view name_of(ForfeitReason reason) {
  switch (reason) {
    case ForfeitReason::none:
      return "none";
    case ForfeitReason::contradiction:
      return "contradiction";
    case ForfeitReason::no_route:
      return "no route";
    case ForfeitReason::lost:
      return "lost";
    case ForfeitReason::finished:
      return "finished";
    case ForfeitReason::gave_up:
      return "gave up";
    case ForfeitReason::not_started:
      return "not started";
    case ForfeitReason::ended_early:
      return "ended early";
    case ForfeitReason::left:
      return "left";
    case ForfeitReason::closed:
      return "closed its pipes";
    case ForfeitReason::hung:
      return "hung";
    case ForfeitReason::late:
      return "late";
    case ForfeitReason::out_of_time:
      return "out of time";
    case ForfeitReason::too_many_processes:
      return "too many processes";
    case ForfeitReason::too_much_memory:
      return "too much memory";
    case ForfeitReason::too_much_written:
      return "too much written";
    case ForfeitReason::flooded:
      return "flooded";
    case ForfeitReason::invalid_answer:
      return "invalid answer";
    case ForfeitReason::interrupted:
      return "interrupted";
    case ForfeitReason::not_judged:
      return "not judged";
  }
  return "unknown";
}

/// One decision: a step, a reset (back to the start, for the speed run) or a forfeit.
struct Action {
  /// A turn and a move; a return to the start; or the end of the contest.
  enum class Kind : std::uint8_t { step, reset, forfeit };

  Kind kind = Kind::step;
  /// Degrees clockwise: -90, 0 or 90; in the worlds in seconds also 180.
  int rotation = 0;
  /// Cells to go after the turn, negative backwards; cut to the longest step of the world.
  int movement = 0;
  /// Of a forfeit; `none` in all others.
  ForfeitReason reason = ForfeitReason::none;

  /// A step: a turn on the spot, then a straight move.
  /// @param rotation degrees clockwise: -90, 0 or 90; in the worlds in seconds also 180.
  /// @param movement cells after the turn; negative: backwards, in the world of steps only.
  static constexpr Action step(int rotation, int movement) {
    return {Kind::step, rotation, movement, ForfeitReason::none};
  }
  /// Ends the search run: back to the start, for a speed run.
  static constexpr Action reset() { return {Kind::reset, 0, 0, ForfeitReason::none}; }
  /// Gives up.
  /// @param reason not `none`.
  static constexpr Action forfeit(ForfeitReason reason) { return {Kind::forfeit, 0, 0, reason}; }

  friend constexpr bool operator==(const Action&, const Action&) = default;
};

}  // namespace labmouse
