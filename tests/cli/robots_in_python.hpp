// Capstone robots and a page for tests of commands on many programs.
#pragma once

#include <string>

namespace labmouse::test {

/// Follows the right wall one cell at a time, then resets once the goal was entered, and goes the same way.
/// @param first lines of Python that run before all others, indented by eight blanks.
inline std::string follower(const std::string& first = "") {
  return "import os, sys\n"
         "class Robot(object):\n"
         "    def __init__(self, dim):\n" +
         first +
         "        self.dim, self.at, self.way, self.runs = dim, [0, 0], 0, 0\n"
         "    def next_move(self, sensors):\n"
         "        middle = (self.dim // 2 - 1, self.dim // 2)\n"
         "        if self.runs == 0 and self.at[0] in middle and self.at[1] in middle:\n"
         "            self.at, self.way, self.runs = [0, 0], 0, 1\n"
         "            return 'Reset', 'Reset'\n"
         "        left, front, right = sensors\n"
         "        turn, move = (90, 1) if right else (0, 1) if front else (-90, 1) if left else (90, 0)\n"
         "        self.way = (self.way + turn // 90) % 4\n"
         "        step = [(0, 1), (1, 0), (0, -1), (-1, 0)][self.way]\n"
         "        self.at = [self.at[0] + step[0] * move, self.at[1] + step[1] * move]\n"
         "        return turn, move\n";
}

/// Does not start.
inline constexpr const char* crashing =
    "class Robot(object):\n    def __init__(self, dim):\n        raise ValueError('no way in')\n"
    "    def next_move(self, sensors):\n        return 0, 1\n";

/// The least that `report` takes for a page.
inline constexpr const char* small_page =
    "<!doctype html><html><head><title>labmouse</title></head><body><!-- labmouse:report --></body></html>\n";

}  // namespace labmouse::test
