// Any bytes as a record: there is a record or a problem, and what is one can be played without a crash. What comes out
// of playing it in a maze that it agrees with is a whole record, which agrees as well.
#include <cstdlib>

#include "labmouse/lab/records/record_file.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

/// For records without a maze: 3x3 cells without inner walls.
const Maze& bare_maze() {
  static const Maze maze(MazeDraft({3, 3}, MazeDraft::Inside::open));
  return maze;
}

void check_replay(RecordFile file, const Maze& maze) {
  ReplayResult played = replay(file, maze);
  if (!played.disagreement.empty()) return;
  file.run = std::move(played.run);
  file.given.clear();
  file.given_end = {};
  if (!replay(file, maze).disagreement.empty()) std::abort();
}

}  // namespace

LABMOUSE_FUZZER(record) {
  const auto result = read_record({reinterpret_cast<const char*>(bytes), size});
  if (result.file.has_value() != result.problems.empty()) std::abort();
  if (!result.file) return 0;
  check_replay(*result.file, bare_maze());
  if (result.file->maze) check_replay(*result.file, *result.file->maze);
  return 0;
}

}  // namespace labmouse::fuzz
