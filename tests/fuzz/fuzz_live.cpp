// Any bytes as the stream of a robot: the same however they arrive, and a map that can be drawn, written and read.
#include "labmouse/lab/live/live_drawing.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(live) {
  const std::string_view stream(reinterpret_cast<const char*>(bytes), size);
  const Size maze{1 + static_cast<int>(size % 9), 2};
  LiveReader whole(maze), parted(maze);
  const std::vector<LiveLine> lines = whole.feed(stream);
  std::vector<LiveLine> found;
  const std::size_t step = 1 + size % 7;
  for (std::size_t i = 0; i < size; i += step)
    for (LiveLine& line : parted.feed(stream.substr(i, step))) found.push_back(line);
  require(found == lines && parted.noise() == whole.noise());
  LiveMap map(maze);
  for (const LiveLine& line : lines) {
    require(line.is_restart || line.seen || !line.fields.empty() || line.drawing);
    for (const LiveFinding& finding : map.add(line)) require(finding.line == line.number && !words_of(finding).empty());
  }
  require(map.fields().size() <= LiveMap::most_fields);
  require(!draw_live(map, true).empty() && !live_summary(map, whole).empty());
  const PartialMap seen = map.map();
  const WriteResult written = write_partial_map(seen);
  require(written.content.has_value());
  const ReadResult read = read_maze(*written.content);
  require(read.maze ? *read.maze == seen.known
                    : read.partial && read.partial->known == seen.known && read.partial->unseen == seen.unseen);
  return 0;
}

}  // namespace labmouse::fuzz
