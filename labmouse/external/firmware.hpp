// The firmware of real robots: programs for chips, which another program runs as a controller.
#pragma once

#include <string>

#include "labmouse/external/launch.hpp"

namespace labmouse {

/// The name of the program that runs them.
inline constexpr const char* firmware_runner_name = "labmouse-avr";

/// The board of firmware without one.
inline constexpr const char* usual_board = "ukmarsbot";

/// The path of the program that runs them: beside this one, where `cmake --install` puts it, or in PATH. Empty where
/// there is none: it is built only where libsimavr is.
std::string firmware_runner();

/// How to start it.
/// @param firmware absolute path of an ELF file.
/// @param board absolute path of a board file, or the name of a built-in board.
Launch firmware_launch(const std::string& runner, const std::string& firmware, const std::string& board);

}  // namespace labmouse
