// A picture of the regions in which one route stays the fastest, and of these routes.
#pragma once

#include <string>

#include "labmouse/lab/routes/route_regions.hpp"

namespace labmouse {

/// A self-contained SVG picture. For one varied number it plots the times of all routes; for two it maps their regions.
/// Below are the routes that win in most of the range (at most three), each in its maze.
std::string draw_regions(const Maze& maze, const RouteRegions& regions, const RegionOrder& order,
                         const std::string& title);

/// The title of that picture.
std::string title_of_regions(const std::string& maze, const std::string& robot);

}  // namespace labmouse
