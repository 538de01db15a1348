#include "tests/fuzz/check_reader.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

// Whatever is read as a maze, by whichever format, is the same maze in every format that can hold it.
LABMOUSE_FUZZER(maze) {
  const std::string_view content(reinterpret_cast<const char*>(bytes), size);
  const ReadResult result = read_maze(content);
  require(result.maze.has_value() == result.problems.empty());
  require(result.problems.size() <= most_problems);
  require(!result.partial || !result.partial->unseen.empty());
  for (const bool gaps_are_places : {false, true}) {
    const ReadResult chosen = read_maze(
        content, {.transposed = true, .repaired = true, .gaps_are_places = gaps_are_places, .closes_unseen = true});
    require(chosen.maze.has_value() == chosen.problems.empty());
  }
  for (const Format* format : all_formats()) check_reader(*format, bytes, size);
  if (!result.maze) return 0;
  for (const Format* format : all_formats())
    if (const WriteResult written = format->write(*result.maze); written.content)
      require(read_maze(*written.content).maze == result.maze);
  return 0;
}

}  // namespace labmouse::fuzz
