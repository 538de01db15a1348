// Any bytes as the actions of a packed record, and as the JSON of one: there is a record or an error, what is a record
// can be played without a crash, and packs to the same actions again.
#include <cstdlib>

#include "labmouse/lab/records/packed_record.hpp"

namespace {

/// 3x3 cells without inner walls.
const labmouse::Maze& bare_maze() {
  static const labmouse::Maze maze(labmouse::MazeDraft({3, 3}, labmouse::MazeDraft::Inside::open));
  return maze;
}

void check(const nlohmann::json& json) {
  const auto result = labmouse::unpack_record(json, bare_maze());
  if (result.file.has_value() != result.error.empty()) std::abort();
  if (!result.file) return;
  if (nlohmann::json(labmouse::pack_record(*result.file))["actions"] != json["actions"]) std::abort();
  labmouse::replay(*result.file, bare_maze());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  check({{"mouse", "flood"}, {"maze", "loop"}, {"actions", text}});
  check(nlohmann::json::parse(text, nullptr, false));
  return 0;
}
