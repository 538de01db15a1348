// Least search times the plain way: what SearchField is tested against. Every move of a search is tried, also stops and
// pivots on the way, from coordinates alone.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse::test {

/// x, y, heading in quarters from north, at rest.
using PlainPlace = std::tuple<int, int, int, bool>;

inline PlainPlace plain(const SearchPlace& place) {
  return {place.pose.cell.x, place.pose.cell.y, static_cast<int>(place.pose.heading), place.at_rest};
}

/// What it takes to leave (x, y) northwards, eastwards, southwards, westwards besides the time, or nothing where it is
/// closed.
using PlainToll = std::function<std::optional<std::int64_t>(int x, int y, int heading)>;

/// The least time from every place from which one of the targets can be entered (Dijkstra 1959, over all moves forwards
/// and then turned round), with dashes over known cells. A
/// move takes some time, even where the toll is below zero.
inline std::map<PlainPlace, std::int64_t> plain_search_times(Size size, const SearchDrive& drive, const PlainToll& toll,
                                                             const CellSet& known, const std::vector<Cell>& targets) {
  struct Move {
    PlainPlace from;
    std::int64_t time;
  };
  std::map<PlainPlace, std::vector<Move>> into;
  constexpr int dx[] = {0, 1, 0, -1}, dy[] = {1, 0, -1, 0};
  for (int x = 0; x < size.width; ++x)
    for (int y = 0; y < size.height; ++y)
      for (int heading = 0; heading < 4; ++heading)
        for (const bool at_rest : {false, true})
          for (int quarters = 0; quarters < 4; ++quarters) {
            const PlainPlace from = {x, y, heading, at_rest};
            const int direction = (heading + quarters) % 4, pivots = quarters == 3 ? 1 : quarters;
            const std::int64_t rest = (at_rest ? 0 : drive.half_cell) + pivots * std::int64_t{drive.quarter};
            if (rest > 0) into[{x, y, direction, true}].push_back({from, rest});
            const auto extra = toll(x, y, direction);
            if (!extra) continue;
            const std::int64_t moving = quarters == 0 ? drive.cell : quarters == 2 ? drive.back : drive.turn;
            into[{x + dx[direction], y + dy[direction], direction, false}].push_back(
                {from,
                 (at_rest ? rest : 0) + std::max<std::int64_t>(1, *extra + (at_rest ? drive.half_cell : moving))});
            if (at_rest || quarters != 0 || !drive.dashes()) continue;
            std::int64_t price = *extra;
            for (int cells = 2;; ++cells) {
              const int last_x = x + (cells - 1) * dx[direction], last_y = y + (cells - 1) * dy[direction];
              const auto more = known.contains({last_x, last_y}) ? toll(last_x, last_y, direction) : std::nullopt;
              if (!more) break;
              price += *more;
              into[{last_x + dx[direction], last_y + dy[direction], direction, false}].push_back(
                  {from, std::max<std::int64_t>(1, price + drive.dash(cells))});
            }
          }
  std::map<PlainPlace, std::int64_t> times;
  std::priority_queue<std::pair<std::int64_t, PlainPlace>, std::vector<std::pair<std::int64_t, PlainPlace>>,
                      std::greater<>>
      queue;
  for (const Cell target : targets)
    for (int heading = 0; heading < 4; ++heading)
      for (const bool at_rest : {false, true}) queue.push({0, {target.x, target.y, heading, at_rest}});
  while (!queue.empty()) {
    const auto [time, place] = queue.top();
    queue.pop();
    if (!times.emplace(place, time).second) continue;
    for (const Move& move : into[place]) queue.push({time + move.time, move.from});
  }
  return times;
}

}  // namespace labmouse::test
