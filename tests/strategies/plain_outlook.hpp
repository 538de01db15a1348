// What ariadne expects of unseen walls, looked up anew for each wall from what is known around it: what its Outlook,
// which keeps all that up to date, is tested against.
#pragma once

#include <algorithm>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/priors.hpp"
#include "labmouse/mouse/sighting.hpp"
#include "labmouse/strategies/ariadne/outlook.hpp"
#include "tests/mouse/plain_priced_field.hpp"

namespace labmouse::test {

class PlainOutlook {
 public:
  PlainOutlook(const Briefing& briefing, const WallPrior* prior)
      : size_(briefing.size), goals_(briefing.goals), prior_(prior), states_(briefing.size, unknown) {}

  /// Takes in a reading: left, ahead, right, in each the nearest wall first. True where a wall was unknown.
  bool learn(Pose pose, const Sighting& seen) {
    bool news = false;
    for (const int side : {-1, 0, 1})
      for (int cells = 0; cells <= seen.towards(side); ++cells) {
        const Heading direction = turned(pose.heading, side);
        const Wall wall = wall_at(neighbour(pose.cell, direction, cells), direction);
        if (state(wall) != unknown) continue;
        learn(wall, cells < seen.towards(side) ? open : closed);
        news = true;
      }
    return news;
  }

  int evidence_against_loops() const { return evidence_; }

  /// -ln P(open) of a wall in 1/32.
  int reluctance(Wall wall) const {
    if (goals_beside(wall) == 2) return 0;
    if (prior_ == nullptr) return 22;  // ln 2
    if (on_rim(wall))
      return prior_->rim[static_cast<unsigned>(std::min(count_of_rim(open), 2) * 8 + count_of_rim(closed))];
    return prior_->walls[static_cast<unsigned>(context(wall))];
  }

  /// Of all inner walls, by a table for unseen ones.
  WallNumbers prices(const ariadne::PriceTable& table) const {
    WallNumbers prices(size_, WallPrices::closed);
    WallSet::all(size_).for_each([&](Wall wall) {
      if (state(wall) == unknown) prices[wall] = table[static_cast<unsigned>(reluctance(wall))];
      if (state(wall) == open) prices[wall] = 0;
    });
    return prices;
  }

 private:
  // The digits of contexts.
  static constexpr int unknown = 0, open = 1, closed = 2;

  int state(Wall wall) const { return on_border(wall, size_) ? closed : states_[wall]; }

  int goals_beside(Wall wall) const {
    return goals_.contains(wall.cell) + goals_.contains(neighbour(wall.cell, wall.side));
  }
  bool has_goal_room() const {
    for (int index = 0; index < size_.area(); ++index) {
      const Cell cell = size_.cell_at(index);
      CellSet room = CellSet::of(cell);
      if (cell.x + 1 >= size_.width || cell.y + 1 >= size_.height) continue;
      for (const Cell other : {Cell{cell.x + 1, cell.y}, Cell{cell.x, cell.y + 1}, Cell{cell.x + 1, cell.y + 1}})
        room.insert(other);
      if (room == goals_) return true;
    }
    return false;
  }
  bool on_rim(Wall wall) const { return goals_beside(wall) == 1 && has_goal_room(); }
  /// How many walls of the rim have been seen in that state. The border, where the room touches it, is not seen.
  int count_of_rim(int wanted) const {
    int count = 0;
    WallSet::all(size_).for_each([&](Wall wall) { count += on_rim(wall) && state(wall) == wanted ? 1 : 0; });
    return count;
  }

  /// The states of the eight walls about a wall, as digits. A wall on an east side is looked at with x and y exchanged.
  int context(Wall wall) const {
    const bool flat = wall.side == Heading::north;
    const auto parallel = [&](int x, int y) {
      return state({{wall.cell.x + (flat ? x : y), wall.cell.y + (flat ? y : x)}, wall.side});
    };
    const auto crossing = [&](int x, int y) {
      return state(
          {{wall.cell.x + (flat ? x : y), wall.cell.y + (flat ? y : x)}, flat ? Heading::east : Heading::north});
    };
    const int digits[] = {parallel(-1, 0), crossing(-1, 0), crossing(-1, 1), parallel(1, 0),
                          crossing(0, 0),  crossing(0, 1),  parallel(0, -1), parallel(0, 1)};
    int number = 0, place = 1;
    for (const int digit : digits) {
      number += digit * place;
      place *= 3;
    }
    return number;
  }

  void learn(Wall wall, int seen) {
    if (prior_ != nullptr && goals_beside(wall) != 2 && !on_rim(wall))
      evidence_ += surprise(*prior_, wall, seen) - surprise(loop_free_prior, wall, seen);
    states_[wall] = seen;
  }
  int surprise(const WallPrior& prior, Wall wall, int seen) const {
    const int reluctance = std::clamp<int>(prior.walls[static_cast<unsigned>(context(wall))], 1, 112);
    return seen == open ? reluctance : complement(reluctance);
  }

  Size size_;
  CellSet goals_;
  const WallPrior* prior_;
  WallNumbers states_;
  int evidence_ = 0;
};

}  // namespace labmouse::test
