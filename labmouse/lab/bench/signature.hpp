// Numbers for the behaviour of everything: equal on every compiler and platform. A change that alters it says why.
#pragma once

#include <cstdint>
#include <string>

namespace labmouse {

/// A hash over all actions of every built-in mouse, with its defaults, in fixed mazes of our
/// generators.
std::uint64_t behaviour_signature();

/// The same of the world in seconds: the tables of robots of all kinds, and every move and run of the mice that drive.
std::uint64_t seconds_signature();

/// The same of the physical world: every bit of where bodies are, and where their controllers believe to be, under
/// noise.
std::uint64_t physical_signature();

/// All in hexadecimal digits, with hyphens between: what `labmouse bench` prints.
std::string signature();

}  // namespace labmouse
