// Classes of robot samples: a contest's random draws give a sound mouse, or one with a weakness for the whole contest.
//
// In the physical world, most failures come from the weaker motor or the tyres. Below 0.3 of the nominal motor, hardly
// any mouse finishes at its usual pace; above that, the value matters little. Tyres have a softer limit: at 0.5 some
// slide, at 0.3 most. Wall detection errors come from infrared sensors far from the nominal values.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "labmouse/body/robot_sample.hpp"

namespace labmouse {

enum class Draws : std::uint8_t {
  sound,                  ///< none of the weaknesses below
  infrared_unequal,       ///< infrared sensors more than 0.3 from the nominal values, in logarithms (root mean square)
  infrared_very_unequal,  ///< or more than 0.5
  tyres_below_50,         ///< they hold less than 0.5 of the nominal value, and so on
  tyres_below_40,
  tyres_below_30,
  tyres_below_20,
  motor_below_30,  ///< the weaker one has less than 0.3 of the nominal value, and so on
  motor_below_25,
  motor_below_20,
  motor_below_15,
};

inline constexpr std::array all_draws = {Draws::sound,          Draws::infrared_unequal, Draws::infrared_very_unequal,
                                         Draws::tyres_below_50, Draws::tyres_below_40,   Draws::tyres_below_30,
                                         Draws::tyres_below_20, Draws::motor_below_30,   Draws::motor_below_25,
                                         Draws::motor_below_20, Draws::motor_below_15};
inline constexpr std::size_t draw_classes = all_draws.size();

constexpr std::string_view name_of(Draws draws) {
  constexpr std::array<std::string_view, draw_classes> names = {"sound",
                                                                "IR gains unequal",
                                                                "IR gains very unequal",
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

/// The class of a robot sample: of weak motors and weak tyres, the one with which fewer contests are finished. Without
/// noise all are sound.
Draws draws_of(const RobotSample& mouse);

}  // namespace labmouse
