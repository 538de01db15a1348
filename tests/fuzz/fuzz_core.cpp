// Any bytes as calls of the C interface of the strategies, in blocks of memory of any size: a wrong call is a status,
// and nothing outside of the block is touched.
#include <memory>
#include <vector>

#include "firmware/labmouse_core.h"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(core) {
  std::size_t at = 0;
  const auto next = [&]() -> std::uint8_t { return at < size ? bytes[at++] : 0; };
  std::unique_ptr<unsigned char[]> memory;
  labmouse_core* mouse = nullptr;
  std::vector<std::uint8_t> saved;
  for (int calls = 0; at < size && calls < 300; ++calls) {
    const std::uint8_t call = next(), a = next();
    switch (call % 16) {
      case 0: {
        const std::uint8_t goals[2][2] = {{next(), next()}, {a, a}};
        labmouse_core_maze maze = {next(), next(), next(), next(), next(), goals, 1, next(), next(), next()};
        maze.goal_count = static_cast<std::uint8_t>(a % 3);
        const int strategy = a % 5;
        const std::size_t side = maze.width > maze.height ? maze.width : maze.height;
        const std::size_t bytes_needed = LABMOUSE_CORE_MEMORY(side, strategy) - (a > 240 ? 1 : 0);
        // Exactly as large as it must be, so that the sanitizer sees what lies beyond.
        memory = std::make_unique<unsigned char[]>(bytes_needed);
        const labmouse_core_status status =
            labmouse_core_create(memory.get(), bytes_needed, strategy, &maze, a == 7 ? nullptr : &mouse);
        if (a == 7) mouse = nullptr;
        require((status == LABMOUSE_CORE_OK) == (mouse != nullptr));
        break;
      }
      case 1:
        labmouse_core_reset(mouse);
        break;
      case 2: {
        std::size_t used = 0;
        saved.assign(LABMOUSE_CORE_SAVED(64) >> a % 8, 0);
        if (labmouse_core_save(mouse, saved.data(), saved.size(), &used) == LABMOUSE_CORE_OK) saved.resize(used);
        break;
      }
      case 3:
        labmouse_core_restore(mouse, saved.data(), saved.size());
        break;
      case 4:
        if (!saved.empty()) saved[a % saved.size()] = next();
        break;
      default: {
        labmouse_core_action action{LABMOUSE_CORE_END, 0, 0};
        if (call & 1U)
          labmouse_core_observe(mouse, a & 3U, a >> 2 & 3U, a >> 4 & 7U);
        else if (labmouse_core_decide(mouse, a == 255 ? nullptr : &action) == LABMOUSE_CORE_OK)
          require(action.quarters >= -1 && action.quarters <= 1 && action.cells >= -8 && action.cells <= 8);
      }
    }
  }
  return 0;
}

}  // namespace labmouse::fuzz
