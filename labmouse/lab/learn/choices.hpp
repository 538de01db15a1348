// The discrete action space for learning: every action of the world of steps by its number.
//
//      number = 7 * turn + movement + 3       turn: 0 left, 1 none, 2 right; movement: -3 to 3 cells
//      21     = reset
//
// There is no forfeit. Every choice is allowed at any time and follows the rules of the world. The mask of
// valid choices leaves out those that are useless by the current reading:
// - a movement that a visible wall would cut short,
// - standing still without a turn,
// - a reset that would only cost its step (before a goal was entered, and in the speed run).
// Straight back (no turn, negative movement) is always valid: a mouse does not see behind itself, and the mask must not
// reveal more than its sensors.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

inline constexpr int longest_choice = 3;
inline constexpr int choices_a_turn = 2 * longest_choice + 1;
inline constexpr int reset_choice = 3 * choices_a_turn;
inline constexpr int choice_count = reset_choice + 1;

/// The action of a choice, 0 to choice_count - 1.
constexpr Action action_of(int choice) {
  if (choice == reset_choice) return Action::reset();
  return Action::step(90 * (choice / choices_a_turn - 1), choice % choices_a_turn - longest_choice);
}

/// The valid choices of a case (see choice_case).
struct ValidChoices {
  /// By choice: 1 if it is valid.
  std::array<std::int8_t, choice_count> mask{};
  /// The valid choices in order, in the first `count` elements.
  std::array<std::uint8_t, choice_count> list{};
  int count = 0;
};

inline constexpr int choice_cases = 2 * 4 * 4 * 4;

/// The number of the case of a reading, in which each distance is clamped to three cells.
constexpr int choice_case(Sighting seen, bool reset_counts) {
  const auto up_to_three = [](int cells) { return cells < longest_choice ? cells : longest_choice; };
  return (((reset_counts ? 1 : 0) * 4 + up_to_three(seen.left)) * 4 + up_to_three(seen.ahead)) * 4 +
         up_to_three(seen.right);
}

constexpr ValidChoices valid_choices(int number_of_case) {
  const bool reset_counts = number_of_case >= 64;
  const std::array<int, 3> seen = {number_of_case / 16 % 4, number_of_case / 4 % 4, number_of_case % 4};
  ValidChoices valid;
  for (int choice = 0; choice < choice_count; ++choice) {
    const int turn = choice / choices_a_turn;
    const int movement = choice % choices_a_turn - longest_choice;
    bool is_valid = false;
    if (choice == reset_choice)
      is_valid = reset_counts;
    else if (movement == 0)
      is_valid = turn != 1;
    else if (movement > 0)
      is_valid = movement <= seen[static_cast<unsigned>(turn)];
    else  // After a turn to the left, back is to the right, and the other way round.
      is_valid = turn == 1 || -movement <= seen[static_cast<unsigned>(2 - turn)];
    if (!is_valid) continue;
    valid.mask[static_cast<unsigned>(choice)] = 1;
    valid.list[static_cast<unsigned>(valid.count++)] = static_cast<std::uint8_t>(choice);
  }
  return valid;
}

/// valid_choices of every case.
inline constexpr auto valid_choices_of_cases = [] {
  std::array<ValidChoices, choice_cases> table;
  for (int number = 0; number < choice_cases; ++number) table[static_cast<unsigned>(number)] = valid_choices(number);
  return table;
}();

}  // namespace labmouse
