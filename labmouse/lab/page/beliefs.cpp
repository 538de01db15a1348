// Distances to the goal by the map of a mouse, frame by frame; and statistics of score differences.
#include <fmt/format.h>

#include <limits>

#include "labmouse/lab/numbers/statistics.hpp"
#include "labmouse/lab/numbers/verdict.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/mouse/distance.hpp"

namespace labmouse {
namespace {

/// Memory limit of an answer, in bytes.
constexpr std::size_t most_bytes = std::size_t{1} << 28U;

/// The closed walls that become known in each frame.
using Discoveries = std::vector<std::vector<Wall>>;

/// Reads `known`, the frame in which each wall becomes known, in the form of Play.
Discoveries read_discoveries(PageRequest& request, const Maze& maze, int frames) {
  const Size size = maze.size();
  const ReadJson& known = request.list("known");
  if (known.size() != 2 * static_cast<std::size_t>(size.area()))
    request.reject(fmt::format("'known' has {} walls instead of {}", known.size(), 2 * size.area()));
  Discoveries discoveries(static_cast<std::size_t>(frames));
  if (!request.error().empty()) return discoveries;
  WallSet closed = WallSet::all(size);
  closed -= maze.open_walls();
  closed.for_each([&](Wall wall) {
    const int place = size.index(wall.cell) + (wall.side == Heading::east ? size.area() : 0);
    const int frame = request.whole(known[static_cast<std::size_t>(place)], "known", -1, frames - 1);
    if (frame >= 0) discoveries[static_cast<std::size_t>(frame)].push_back(wall);
  });
  return discoveries;
}

/// Appends the distances as 16-bit little-endian numbers, 65535 for unreachable cells.
void append(const DistanceField& field, std::string& bytes) {
  for (int i = 0; i < field.size().area(); ++i) {
    const Cell cell = field.size().cell_at(i);
    const unsigned steps =
        field.reaches(cell) ? static_cast<unsigned>(field.at(cell)) : std::numeric_limits<std::uint16_t>::max();
    bytes += static_cast<char>(steps & 255U);
    bytes += static_cast<char>(steps >> 8U);
  }
}

std::string beliefs_of(const Maze& maze, int stride, const Discoveries& discoveries) {
  const std::size_t frame_bytes = 2 * static_cast<std::size_t>(maze.size().area());
  WallSet possible = WallSet::all(maze.size());
  DistanceField field(maze.size(), strides(stride));
  std::string bytes;
  bytes.reserve(discoveries.size() * frame_bytes);
  for (std::size_t frame = 0; frame < discoveries.size(); ++frame) {
    for (const Wall wall : discoveries[frame]) possible.erase(wall);
    if (frame > 0 && discoveries[frame].empty()) {
      bytes.append(bytes, bytes.size() - frame_bytes, frame_bytes);
      continue;
    }
    field.fill(possible, maze.goals());
    append(field, bytes);
  }
  return bytes;
}

}  // namespace

PageReply answer_beliefs(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  const NamedMaze maze = request.maze();
  const int frames = request.whole("frames", 1, std::numeric_limits<int>::max());
  const int stride = request.whole("stride", 1, Motion::max_longest);
  if (!request.error().empty()) return failed(request.error());
  const std::size_t bytes = 2 * static_cast<std::size_t>(maze.maze.size().area()) * static_cast<std::size_t>(frames);
  if (bytes > most_bytes) return failed(fmt::format("{} frames are too many for the page", frames));
  const Discoveries discoveries = read_discoveries(request, maze.maze, frames);
  if (!request.error().empty()) return failed(request.error());
  return {Json::object(), beliefs_of(maze.maze, stride, discoveries), {}};
}

PageReply answer_compare(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  std::vector<double> differences;
  for (const ReadJson& each : request.list("differences"))
    if (each.is_number())
      differences.push_back(each.get<double>());
    else
      request.reject("'differences' has an entry that is not a number");
  const std::uint64_t seed = request.has("seed") ? request.seed() : 1;
  if (!request.error().empty()) return failed(request.error());
  const PairedDifference found = paired_difference(differences, seed);
  return answered({{"count", found.count},
                   {"mean", found.mean},
                   {"interval", {found.interval.low, found.interval.high}},
                   {"below", found.below},
                   {"equal", found.equal},
                   {"above", found.above},
                   {"sign_test", found.sign_test},
                   {"p", found.p},
                   {"verdict", name_of(verdict_of(found, found.p))}});
}

}  // namespace labmouse
