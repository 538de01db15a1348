#include "labmouse/strategies/ariadne/outlook.hpp"

#include <algorithm>

#include "labmouse/mouse/priors.hpp"

namespace labmouse::ariadne {
namespace {

constexpr int even = 22;  // -ln(1/2) in 1/32
constexpr PriceTable all_open{};

/// Whether the cells are a room of 2×2.
bool is_room(const CellSet& cells) {
  bool first = true, room = cells.count() == 4;
  cells.for_each([&](Cell cell) {
    if (first)
      for (const Cell other : {Cell{cell.x + 1, cell.y}, Cell{cell.x, cell.y + 1}, Cell{cell.x + 1, cell.y + 1}})
        room = room && cells.contains(other);
    first = false;
  });
  return room;
}

}  // namespace

Outlook::Outlook(const Briefing& briefing, const WallPrior* prior)
    : size_(briefing.size),
      sight_(briefing.sight),
      prior_(prior),
      table_(&all_open),
      contexts_(briefing.size),
      prices_(briefing.size),
      unknown_(WallSet::all(briefing.size)) {
  const bool room = is_room(briefing.goals);
  unknown_.for_each([&](Wall wall) {
    const int goals = briefing.goals.contains(wall.cell) + briefing.goals.contains(neighbour(wall.cell, wall.side));
    if (goals == 2) inside_.insert(wall);
    if (goals == 1 && room) rim_.insert(wall);
  });
  price(all_open);
}

bool Outlook::learn(Pose pose, const Sighting& seen) {
  bool news = false;
  for (const int side : {-1, 0, 1}) {
    const Heading direction = turned(pose.heading, side);
    Cell cell = pose.cell;
    for (int passed = 0; passed <= seen.towards(side) && passed < sight_; ++passed, cell = neighbour(cell, direction)) {
      const Wall wall = wall_at(cell, direction);
      if (!unknown_.contains(wall)) continue;
      learn(wall, passed < seen.towards(side));
      news = true;
    }
  }
  return news;
}

bool Outlook::learn(const Knowledge& knowledge) {
  WallSet news = unknown_;
  news -= knowledge.unknown();
  news.for_each([&](Wall wall) { learn(wall, knowledge.open().contains(wall)); });
  return !news.empty();
}

void Outlook::learn(Wall wall, bool open) {
  weigh(wall, open);
  unknown_.erase(wall);
  prices_.set(wall, open ? 0 : WallPrices::closed);
  contexts_.learn(wall, open, [&](Wall other) { price(other); });
  if (!rim_.contains(wall)) return;
  ++(open ? rim_open_ : rim_closed_);
  rim_.for_each([&](Wall other) { price(other); });
}

/// Adds a wall's log-likelihood ratio between both kinds of mazes. Probabilities are limited on both sides, so that one
/// wall cannot decide.
void Outlook::weigh(Wall wall, bool open) {
  if (prior_ == nullptr || rim_.contains(wall) || inside_.contains(wall)) return;
  const auto surprise = [&](const WallPrior& prior) {
    const int reluctance = std::clamp<int>(prior.walls[static_cast<unsigned>(contexts_.of(wall))], 1, most_reluctance);
    return open ? reluctance : complement(reluctance);
  };
  evidence_ += surprise(*prior_) - surprise(loop_free_prior);
}

void Outlook::price(const PriceTable& table) {
  table_ = &table;
  unknown_.for_each([&](Wall wall) { price(wall); });
}

void Outlook::price(Wall wall) {
  if (unknown_.contains(wall)) prices_.set(wall, (*table_)[static_cast<unsigned>(reluctance(wall))]);
}

int Outlook::reluctance(Wall wall) const {
  if (inside_.contains(wall)) return 0;
  if (prior_ == nullptr) return even;
  if (rim_.contains(wall)) return prior_->rim[static_cast<unsigned>(rim_context(rim_open_, rim_closed_))];
  return prior_->walls[static_cast<unsigned>(contexts_.of(wall))];
}

}  // namespace labmouse::ariadne
