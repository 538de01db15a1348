// The few colours of SVG pictures.
//
// Each element carries its colour on light ground as an attribute, which every renderer understands, and a class; a
// style sheet for dark mode overrides the attributes by these classes.
// Hues after Okabe and Ito, "Color Universal Design" (2008): blue, green, amber and vermilion, which colour-blind eyes
// tell apart, and a dark purple; heat is a blue with growing contrast to the background, explored cells are warm greys.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "labmouse/lab/drawing/heat.hpp"

namespace labmouse::drawing {

struct Tone {
  std::string_view name;
  std::string_view light;
  std::string_view dark;
};

inline constexpr Tone paper = {"paper", "#ffffff", "#14181d"};
inline constexpr Tone ink = {"ink", "#1b2530", "#e4e9ee"};
inline constexpr Tone muted = {"muted", "#5a6672", "#98a4b0"};
inline constexpr Tone faint = {"faint", "#a3aeb9", "#5a6672"};
inline constexpr Tone post = {"post", "#d3dae0", "#353e47"};
inline constexpr Tone start = {"start", "#fbe2a0", "#5c4611"};
inline constexpr Tone goal = {"goal", "#b9e6d3", "#0d5240"};
inline constexpr Tone route = {"route", "#d55e00", "#ff9147"};
inline constexpr Tone to_goal = {"to-goal", "#0072b2", "#56b4e9"};
inline constexpr Tone onwards = {"onwards", "#00805d", "#3fd0a3"};
inline constexpr Tone wrong = {"wrong", "#b8418c", "#f08fc8"};
inline constexpr Tone candidate = {"candidate", "#a86a00", "#f0b648"};
inline constexpr Tone discovered = {"discovered", "#f1ede7", "#2e2a23"};
inline constexpr Tone visited = {"visited", "#d8cfc2", "#50483c"};
/// By heat level, from one visit to the most.
inline constexpr std::array<Tone, Heat::levels> heat_tones = {{
    {"heat1", "#e6f0f9", "#15293b"},
    {"heat2", "#d0e3f3", "#17344f"},
    {"heat3", "#b5d3ec", "#1a4265"},
    {"heat4", "#97c1e4", "#1e517e"},
    {"heat5", "#76addb", "#236198"},
    {"heat6", "#5598d0", "#2972b2"},
}};

/// The attributes for an area and for a line of that tone.
std::string fill(const Tone& tone);
std::string stroke(const Tone& tone);
/// Both at once.
std::string fill_and_stroke(const Tone& area, const Tone& line);

/// The style sheet for dark ground, for elements inside of one with the class `labmouse`: rules for the tones that
/// every picture may have, and for those named.
std::string dark_style_sheet(std::span<const Tone> more);

}  // namespace labmouse::drawing
