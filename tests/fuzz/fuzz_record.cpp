// Any bytes as a record: there is a record or a problem, and what is one can be played without a crash. What comes out
// of playing it in a maze that it agrees with is a whole record, which agrees as well.
#include <cstdlib>

#include "labmouse/lab/records/record_file.hpp"

namespace {

/// For records without a maze: 3x3 cells without inner walls.
const labmouse::Maze& bare_maze() {
  static const labmouse::Maze maze(labmouse::MazeDraft({3, 3}, labmouse::MazeDraft::Inside::open));
  return maze;
}

void check_replay(labmouse::RecordFile file, const labmouse::Maze& maze) {
  labmouse::ReplayResult played = labmouse::replay(file, maze);
  if (!played.disagreement.empty()) return;
  file.run = std::move(played.run);
  file.given.clear();
  file.given_end = {};
  if (!labmouse::replay(file, maze).disagreement.empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto result = labmouse::read_record({reinterpret_cast<const char*>(bytes), size});
  if (result.file.has_value() != result.problems.empty()) std::abort();
  if (!result.file) return 0;
  check_replay(*result.file, bare_maze());
  if (result.file->maze) check_replay(*result.file, *result.file->maze);
  return 0;
}
