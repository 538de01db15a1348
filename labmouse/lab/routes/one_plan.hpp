// Plans the fastest route of one maze.
#pragma once

#include <memory>
#include <utility>

#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {

/// The fastest route from the start of a maze to its goals through `passages`; its time is no_time where there is none.
inline DriveRoute fastest_route(const Maze& maze, const WallSet& passages, std::shared_ptr<const RouteTables> tables) {
  const Pose start = {maze.start(), maze.start_heading()};
  FastestRoutes routes(maze.size(), std::move(tables));
  routes.fill(passages, maze.goals());
  DriveRoute route;
  routes.route_from(start, route);
  return route;
}

}  // namespace labmouse
