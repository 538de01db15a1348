// Hashes of the program's behaviour, equal on every compiler and platform. A commit that changes one must give the
// reason.
#pragma once

#include <cstdint>
#include <string>

namespace labmouse {

/// A hash of all actions of every built-in mouse, with its defaults, in fixed generated mazes.
std::uint64_t behaviour_signature();

/// The same for the world of seconds: a hash of the tables of two robots, and of every move and run of the mice that
/// drive.
std::uint64_t seconds_signature();

/// The same for the physical world with noise: a hash of every bit of the true and the estimated poses.
std::uint64_t physical_signature();

/// All three in hexadecimal digits, joined by hyphens, as `labmouse bench` prints them.
std::string signature();

}  // namespace labmouse
