// The order in which races keep their mice and mazes, for those who need its positions before a race begins.
#pragma once

namespace labmouse {

/// Whether a mouse or maze stands before another one.
inline constexpr auto in_race_order = [](const auto& a, const auto& b) { return a.name < b.name; };

}  // namespace labmouse
