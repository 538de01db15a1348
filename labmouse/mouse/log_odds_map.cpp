#include "labmouse/mouse/log_odds_map.hpp"

#include <algorithm>
#include <cstdlib>

#include "labmouse/mouse/priors.hpp"
#include "labmouse/mouse/wall_contexts.hpp"

namespace labmouse {

LogOddsMap::LogOddsMap(Size size, MapKind kind)
    : size_(size),
      kind_(kind),
      prior_(kind == MapKind::learned ? contest_prior_for(size) : nullptr),
      odds_(2 * static_cast<std::size_t>(size.area())),
      view_(size, 1),
      costs_(static_cast<std::size_t>(size.area())),
      entered_(costs_.size()) {}

Sighting LogOddsMap::sighting(const Pose& pose) const {
  const auto open_to = [&](Heading side) { return view_.open().contains(wall_at(pose.cell, side)) ? 1 : 0; };
  return {open_to(left_of(pose.heading)), open_to(pose.heading), open_to(right_of(pose.heading))};
}

std::size_t LogOddsMap::index_of(Wall wall) const {
  return static_cast<std::size_t>(2 * size_.index(wall.cell) + (wall.side == Heading::east ? 1 : 0));
}

int LogOddsMap::odds(Wall wall) const { return on_border(wall, size_) ? most : odds_[index_of(wall)]; }

int LogOddsMap::expected(Wall wall) const {
  if (prior_ == nullptr) return 0;
  const int open = std::clamp<int>(prior_->walls[static_cast<unsigned>(context_of(wall, view_))], 1, most_reluctance);
  return (open - complement(open)) * evidence_a_nat / reluctance_a_nat;
}

LogOddsMap::News LogOddsMap::add(Wall wall, int evidence) {
  if (on_border(wall, size_)) return News::none;
  std::int8_t& odds = odds_[index_of(wall)];
  const WallState state = view_.state(wall);
  if (state == WallState::unknown) {
    odds = static_cast<std::int8_t>(std::clamp(expected(wall) + evidence, -most, most));
    view_.learn(wall, odds <= 0);
    return News::learned;
  }
  const bool against = state == WallState::closed ? evidence < 0 : evidence > 0;
  const News said = against && std::abs(evidence) >= telling ? News::contradicted : News::none;
  if (kind_ == MapKind::first) return said;
  odds = static_cast<std::int8_t>(std::clamp(odds + evidence, -most, most));
  if (state == WallState::closed ? odds > -telling : odds < telling) return said;
  ++version_;
  view_.forget(wall);
  view_.learn(wall, state == WallState::closed);
  return News::turned;
}

void LogOddsMap::weaken(Wall wall, int evidence) {
  if (on_border(wall, size_) || view_.state(wall) == WallState::unknown) return;
  std::int8_t& odds = odds_[index_of(wall)];
  const int less = odds - evidence / 2;
  odds = static_cast<std::int8_t>(view_.state(wall) == WallState::closed
                                      ? std::clamp(less, std::min<int>(0, odds), most)
                                      : std::clamp(less, -most, std::max<int>(0, odds)));
}

void LogOddsMap::forget(Wall wall) {
  if (on_border(wall, size_)) return;
  odds_[index_of(wall)] = 0;
  if (view_.state(wall) == WallState::unknown) return;
  ++version_;
  view_.forget(wall);
}

bool LogOddsMap::weaken_path(Cell from, const CellSet& to) {
  // Bellman-Ford over cells: simple, and fast enough for a small maze and rare calls.
  constexpr int far = 1 << 28;
  std::fill(costs_.begin(), costs_.end(), far);
  const auto at = [&](Cell cell) { return static_cast<std::size_t>(size_.index(cell)); };
  const auto price = [&](Wall wall) {
    return view_.state(wall) == WallState::closed ? std::max(1, odds(wall) + most) : 0;
  };
  costs_[at(from)] = 0;
  for (bool any = true; any;) {
    any = false;
    CellSet::all(size_).for_each([&](Cell cell) {
      if (costs_[at(cell)] == far) return;
      for (const Heading heading : all_headings) {
        const Wall wall = wall_at(cell, heading);
        if (on_border(wall, size_)) continue;
        const std::size_t next = at(neighbour(cell, heading));
        if (costs_[at(cell)] + price(wall) >= costs_[next]) continue;
        costs_[next] = costs_[at(cell)] + price(wall);
        entered_[next] = heading;
        any = true;
      }
    });
  }
  Cell best = from;
  int least = far;
  to.for_each([&](Cell cell) {
    if (costs_[at(cell)] < least) least = costs_[at(best = cell)];
  });
  if (least == far || least == 0) return false;
  for (Cell cell = best; cell != from;) {
    const Heading heading = entered_[at(cell)];
    cell = neighbour(cell, opposite(heading));
    if (view_.state(wall_at(cell, heading)) == WallState::closed) forget(wall_at(cell, heading));
  }
  return true;
}

}  // namespace labmouse
