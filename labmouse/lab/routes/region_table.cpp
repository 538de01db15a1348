#include <fmt/format.h>

#include "labmouse/lab/records/drive_notation.hpp"
#include "labmouse/lab/routes/region_data.hpp"
#include "labmouse/lab/routes/route_regions.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

std::string range_text(const VariedNumber& number) {
  const std::string unit = unit_of(number);
  return fmt::format("{} from {:.10g} to {:.10g}{}{}", number.key, number.from, number.to, unit.empty() ? "" : " ",
                     unit);
}

/// The number of decimals that separates the two sides of a border.
int digits_of(const RegionOrder& order) {
  int digits = 0;
  for (double close = order.sharpness * (order.across.to - order.across.from); close < 1.0 && digits < 6; close *= 10.0)
    ++digits;
  return digits;
}

std::string name_of_route(int route) { return route == RouteRegion::refused ? "-" : letter_of(route); }

std::string region_line(const RouteRegion& region, const RouteRegions& all, int digits) {
  const std::string range = fmt::format("{:>12.{}f} {:>12.{}f}", region.from, digits, region.to, digits);
  if (region.route == RouteRegion::refused) return fmt::format("{:<6} {:>6} {}  {}\n", "-", "-", range, region.refusal);
  const auto& route = all.routes[static_cast<std::size_t>(region.route)];
  std::string line = fmt::format("{:<6} {:>6} {} {:>9.3f} {:>9.3f}", letter_of(region.route), route.cells, range,
                                 region.time_from / 1e6, region.time_to / 1e6);
  if (region.runner_up)
    line += fmt::format("  {:.2f} % ahead of {}", 100.0 * region.runner_up->loss, letter_of(region.runner_up->route));
  return line + "\n";
}

std::string one_row(const RouteRegions& regions, const RegionOrder& order) {
  std::string text =
      fmt::format("{:<6} {:>6} {:>12} {:>12} {:>9} {:>9}\n", "route", "cells", "from", "to", "s there", "s there");
  for (const RouteRegion& region : regions.rows.front().regions) text += region_line(region, regions, digits_of(order));
  return text;
}

/// The routes of a row and the borders between them, such as "A 27431 B"; a border is the first value of the right
/// side.
std::string row_text(const RegionRow& row, int digits) {
  std::string text;
  for (const RouteRegion& region : row.regions) {
    if (!text.empty()) text += fmt::format(" {:.{}f} ", region.from, digits);
    text += name_of_route(region.route);
  }
  return text;
}

std::string many_rows(const RouteRegions& regions, const RegionOrder& order) {
  std::string text;
  for (std::size_t i = 0; i < regions.routes.size(); ++i)
    text += fmt::format("{:<6} {:>4} cells\n", letter_of(static_cast<int>(i)), regions.routes[i].cells);
  text += fmt::format("\n{:>12}  route, the least {} from which the next one wins, that route, ...\n", order.along->key,
                      order.across.key);
  for (const RegionRow& row : regions.rows)
    text += fmt::format("{:>12.10g}  {}\n", row.at, row_text(row, digits_of(order)));
  return text;
}

Json number_json(const VariedNumber& number) {
  return {{"key", number.key}, {"unit", unit_of(number)}, {"from", number.from}, {"to", number.to}};
}

Json region_json(const RouteRegion& region) {
  Json json = {{"from", region.from}, {"to", region.to}};
  if (region.route == RouteRegion::refused) {
    json["route"] = nullptr;
    json["refusal"] = region.refusal;
    return json;
  }
  json["route"] = letter_of(region.route);
  json["time_from_us"] = region.time_from;
  json["time_to_us"] = region.time_to;
  json["runner_up"] = region.runner_up ? Json(letter_of(region.runner_up->route)) : Json(nullptr);
  json["margin"] = region.runner_up ? Json(region.runner_up->loss) : Json(nullptr);
  return json;
}

Json route_json(const RegionRoute& route, int number) {
  Json walls = Json::array();
  route.walls.for_each([&](Wall wall) {
    walls.push_back({wall.cell.x, wall.cell.y, wall.side == Heading::north ? "north" : "east"});
  });
  return {{"name", letter_of(number)},
          {"cells", route.cells},
          {"route", notation_of(route.route, route.model.tables)},
          {"passes", std::move(walls)}};
}

}  // namespace

std::string letter_of(int route) {
  const std::string letter(1, static_cast<char>('A' + route % 26));
  return route < 26 ? letter : letter + std::to_string(route / 26);
}

std::string table_of(const RouteRegions& regions, const RegionOrder& order, const std::string& maze,
                     const std::string& robot) {
  std::string text =
      fmt::format("{}: the fastest routes of {}, {}", shown(maze), shown(robot), range_text(order.across));
  if (order.along) text += ", and " + range_text(*order.along);
  text += "\n\n";
  text += order.along ? many_rows(regions, order) : one_row(regions, order);
  return text + fmt::format(
                    "\n{}. A route counts by the passages that it leads through; each border lies between two "
                    "plans that are at most {:.3g} apart.\n",
                    counted(regions.plans, "plan", "plans"), order.sharpness * (order.across.to - order.across.from));
}

Json regions_json(const RouteRegions& regions, const RegionOrder& order, const std::string& maze,
                  const std::string& robot) {
  Json json = {{"labmouse", version()}, {"robot", robot}, {"maze", maze}, {"vary", number_json(order.across)}};
  json["and"] = order.along ? number_json(*order.along) : Json(nullptr);
  json["plans"] = regions.plans;
  json["routes"] = Json::array();
  for (std::size_t i = 0; i < regions.routes.size(); ++i)
    json["routes"].push_back(route_json(regions.routes[i], static_cast<int>(i)));
  json["rows"] = Json::array();
  for (const RegionRow& row : regions.rows) {
    Json row_json = Json::array();
    for (const RouteRegion& region : row.regions) row_json.push_back(region_json(region));
    json["rows"].push_back({{"at", order.along ? Json(row.at) : Json(nullptr)}, {"regions", std::move(row_json)}});
  }
  return json;
}

std::string json_of(const RouteRegions& regions, const RegionOrder& order, const std::string& maze,
                    const std::string& robot) {
  return text_of(regions_json(regions, order, maze, robot));
}

}  // namespace labmouse
