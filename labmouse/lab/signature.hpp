// One number for the behaviour of everything: equal on every compiler and platform. A change that alters it says why.
#pragma once

#include <cstdint>

namespace labmouse {

/// A hash over all actions of every mouse on the roster, with its defaults, in fixed mazes of our generators.
std::uint64_t behaviour_signature();

}  // namespace labmouse
