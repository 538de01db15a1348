#include "labmouse/lab/races/contest_list.hpp"

#include "labmouse/chance/dice.hpp"

namespace labmouse {

std::uint64_t contest_seed(std::uint64_t seed, std::string_view maze_name, int run) {
  // 53 bits: a JSON reader that keeps numbers as doubles gets them whole.
  return seed_for(seed, maze_name.substr(maze_name.rfind('/') + 1), static_cast<std::uint64_t>(run)) >> 11U;
}

}  // namespace labmouse
