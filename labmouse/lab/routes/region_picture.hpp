// Which route wins for which robot, as a picture: the regions, and the routes beside them.
#pragma once

#include <string>

#include "labmouse/lab/routes/route_regions.hpp"

namespace labmouse {

/// One self-contained SVG picture: of one number that is varied, the times of all routes over it; of two, the map of
/// their regions. Below it the routes that win in most of the range, at most three, each in its maze.
std::string draw_regions(const Maze& maze, const RouteRegions& regions, const RegionOrder& order,
                         const std::string& title);

/// The title of that picture.
std::string title_of_regions(const std::string& maze, const std::string& robot);

}  // namespace labmouse
