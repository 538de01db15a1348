#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {
namespace {

/// The time of the way to the end behind the last turn, if the mouse has so many cells to stop in.
DriveTime time_to_end(const DriveRoute& route, const DriveTables& tables, int room) {
  const auto& segments = route.segments;
  const bool straight = segments.back().kind == DriveSegment::Kind::straight;
  const int units = straight ? segments.back().units : 0;
  const std::size_t before = segments.size() - (straight ? 1 : 0);
  if (before == 0) return tables.whole_way(units, room);
  return tables.finish_from(units, tables.turns[segments[before - 1].turn].to, room);
}

}  // namespace

int stopping_room(const DriveRoute& route, const DriveTables& tables) {
  if (route.segments.empty()) return 0;
  const DriveSegment& last = route.segments.back();
  const DriveTime taken = last.kind == DriveSegment::Kind::straight ? last.end - last.begin : 0;
  int room = 0;
  while (room + 1 < tables.rooms() && time_to_end(route, tables, room) > taken) ++room;
  return room;
}

}  // namespace labmouse
