// What a contest's draws make of a mouse: one that is sound, or one that is weak somewhere, all through the contest.
//
// Counted in the physical world, what breaks mice is their weakest motor or their tyres. With less than 0.3 of what the
// book says of a motor hardly any finishes at its usual pace, and with more it does not matter how much more. Tyres are
// not as sharp: with 0.5 some slide, with 0.3 most. Of the others, it is infrared sensors far from the nominal values
// that make mice detect walls wrongly.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "labmouse/body/robot_sample.hpp"

namespace labmouse {

enum class Draws : std::uint8_t {
  sound,           ///< none of what follows
  eyes_apart,      ///< infrared sensors more than 0.3 from the nominal values, in logarithms (root mean square)
  eyes_far_apart,  ///< or more than 0.5
  tyres_below_50,  ///< they hold less than 0.5 of the nominal value, and so on
  tyres_below_40,
  tyres_below_30,
  tyres_below_20,
  motor_below_30,  ///< the weaker one has less than 0.3 of the nominal value, and so on
  motor_below_25,
  motor_below_20,
  motor_below_15,
};

inline constexpr std::array all_draws = {Draws::sound,          Draws::eyes_apart,     Draws::eyes_far_apart,
                                         Draws::tyres_below_50, Draws::tyres_below_40, Draws::tyres_below_30,
                                         Draws::tyres_below_20, Draws::motor_below_30, Draws::motor_below_25,
                                         Draws::motor_below_20, Draws::motor_below_15};
inline constexpr std::size_t draw_classes = all_draws.size();

constexpr std::string_view name_of(Draws draws) {
  constexpr std::array<std::string_view, draw_classes> names = {"sound",
                                                                "eyes apart",
                                                                "eyes far apart",
                                                                "tyres below 50 %",
                                                                "tyres below 40 %",
                                                                "tyres below 30 %",
                                                                "tyres below 20 %",
                                                                "motor below 30 %",
                                                                "motor below 25 %",
                                                                "motor below 20 %",
                                                                "motor below 15 %"};
  return names[static_cast<std::size_t>(draws)];
}

/// Of weak motors and weak tyres, whichever finish fewer contests. Without noise all are sound.
Draws draws_of(const RobotSample& mouse);

}  // namespace labmouse
