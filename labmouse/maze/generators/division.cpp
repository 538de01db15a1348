// Recursive division: part a room by a wall with one gap, then each half, until every room is one cell wide. Long
// straight walls and bottlenecks.
//
// Source: folklore of the 1990s; described by Buck, "Mazes for Programmers" (2015).
#include "labmouse/maze/generators/loops.hpp"

namespace labmouse {
namespace {

struct Room {
  Cell corner;  // in the south-west
  Size size;
};

// Divides the room by a north-south wall east of one of its columns, with a gap in one row.
void part_upright(MazeDraft& draft, Room room, std::vector<Room>& rooms, Rng& rng) {
  const int west = 1 + rng.below(room.size.width - 1);
  const int gap = rng.below(room.size.height);
  for (int y = 0; y < room.size.height; ++y)
    if (y != gap) draft.close({room.corner.x + west - 1, room.corner.y + y}, Heading::east);
  rooms.push_back({room.corner, {west, room.size.height}});
  rooms.push_back({{room.corner.x + west, room.corner.y}, {room.size.width - west, room.size.height}});
}

// Divides the room by an east-west wall north of one of its rows, with a gap in one column.
void part_level(MazeDraft& draft, Room room, std::vector<Room>& rooms, Rng& rng) {
  const int south = 1 + rng.below(room.size.height - 1);
  const int gap = rng.below(room.size.width);
  for (int x = 0; x < room.size.width; ++x)
    if (x != gap) draft.close({room.corner.x + x, room.corner.y + south - 1}, Heading::north);
  rooms.push_back({room.corner, {room.size.width, south}});
  rooms.push_back({{room.corner.x, room.corner.y + south}, {room.size.width, room.size.height - south}});
}

Maze make_division(const GeneratorOrder& order) {
  Rng rng(order.seed);
  MazeDraft draft(order.size, MazeDraft::Inside::open);
  std::vector<Room> rooms = {{draft.start(), order.size}};
  while (!rooms.empty()) {
    const Room room = rooms.back();
    rooms.pop_back();
    const auto [width, height] = room.size;
    if (width == 1 || height == 1) continue;
    // Across the longer side, so that rooms stay roughly square.
    const bool upright = width > height || (width == height && rng.chance(1, 2));
    (upright ? part_upright : part_level)(draft, room, rooms, rng);
  }
  open_loops(draft, order);
  return Maze(draft);
}

}  // namespace

constinit const Generator division_generator = {
    .name = "division",
    .summary = "long straight walls with gaps",
    .refuses = refuses_out_of_range,
    .make = make_division,
};

}  // namespace labmouse
