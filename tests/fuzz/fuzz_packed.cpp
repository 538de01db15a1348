// Any bytes as the actions of a packed record, and as the JSON of one: there is a record or an error, what is a record
// can be played without a crash, and packs to the same actions again. Only reasons of a forfeit get their names of
// today.
#include <cstdlib>

#include "labmouse/lab/records/packed_record.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

/// 3x3 cells without inner walls.
const Maze& bare_maze() {
  static const Maze maze(MazeDraft({3, 3}, MazeDraft::Inside::open));
  return maze;
}

void check(const nlohmann::json& json) {
  const auto result = unpack_record(json, bare_maze());
  if (result.file.has_value() != result.error.empty()) std::abort();
  if (!result.file) return;
  const nlohmann::json packed = pack_record(*result.file);
  if (packed["actions"] != json["actions"]) {
    const bool forfeits = json["actions"].get<std::string>().find('!') != std::string::npos;
    const auto again = unpack_record(packed, bare_maze());
    if (!forfeits || !again.file || again.file->run.steps != result.file->run.steps) std::abort();
  }
  replay(*result.file, bare_maze());
}

}  // namespace

LABMOUSE_FUZZER(packed) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  check({{"mouse", "flood"}, {"maze", "loop"}, {"actions", text}});
  check(nlohmann::json::parse(text, nullptr, false));
  return 0;
}

}  // namespace labmouse::fuzz
