#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

void RouteEnd::pass(const DriveSegment& segment) {
  empty_ = false;
  last_ = segment;
  if (segment.kind == DriveSegment::Kind::turn) turn_ = segment.turn;
}

int RouteEnd::room(const DriveTables& tables) const {
  if (empty_) return 0;
  const bool straight = last_.kind == DriveSegment::Kind::straight;
  const DriveTime taken = straight ? last_.end - last_.begin : 0;
  const auto time = [&](int room) {
    return turn_ == none ? tables.whole_way(last_.units, room)
                         : tables.finish_from(last_.units, tables.turns[static_cast<std::size_t>(turn_)].to, room);
  };
  int room = 0;
  while (room + 1 < tables.rooms() && time(room) > taken) ++room;
  return room;
}

int stopping_room(const DriveRoute& route, const DriveTables& tables) {
  RouteEnd end;
  for (const DriveSegment& segment : route.segments) end.pass(segment);
  return end.room(tables);
}

}  // namespace labmouse
