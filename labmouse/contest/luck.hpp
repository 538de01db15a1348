// What a contest's draws make of a mouse: one that is sound, or one that is weak somewhere, all through the contest.
//
// Counted in the physical world, what breaks mice is the weakest of their motors and their tyres: with less than 0.3 of
// what the book says hardly any finishes at its usual pace, and with more than 0.4 it hardly matters how much more. Of
// those, it is infrared sensors far from the book that make mice misread.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "labmouse/body/specimen.hpp"

namespace labmouse {

enum class Luck : std::uint8_t {
  sound,           ///< no motor and no tyre has less than 0.4 of what the book says
  eyes_apart,      ///< the same with infrared sensors more than 0.4 from the book, in logarithms (root mean square)
  eyes_far_apart,  ///< or more than 0.8
  weak_below_40,   ///< the weakest has less than 0.4, and so on
  weak_below_30,
  weak_below_25,
  weak_below_20,
  weak_below_15,
};

inline constexpr std::array all_luck = {Luck::sound,         Luck::eyes_apart,    Luck::eyes_far_apart,
                                        Luck::weak_below_40, Luck::weak_below_30, Luck::weak_below_25,
                                        Luck::weak_below_20, Luck::weak_below_15};
inline constexpr std::size_t luck_classes = all_luck.size();

constexpr std::string_view name_of(Luck luck) {
  constexpr std::array<std::string_view, luck_classes> names = {"sound",           "eyes apart",      "eyes far apart",
                                                                "weak below 40 %", "weak below 30 %", "weak below 25 %",
                                                                "weak below 20 %", "weak below 15 %"};
  return names[static_cast<std::size_t>(luck)];
}

/// Without noise all are sound.
Luck luck_of(const Specimen& mouse);

}  // namespace labmouse
