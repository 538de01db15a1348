#include "labmouse/maze/generators/wall_growth.hpp"

#include <algorithm>

#include "labmouse/maze/generators/loops.hpp"

namespace labmouse {
namespace {

// Tuned by eye, and by the counts of dead ends, turns and straights, to resemble contest mazes.
constexpr int cells_of_a_patch = 24;
constexpr int longest_wall = 14;
constexpr int obedience = 88;     // per cent of pieces that follow the grain where they can
constexpr int newest_first = 90;  // per cent of walls that grow from the newest post

bool is_level(Heading heading) { return heading == Heading::east || heading == Heading::west; }

// Whether a piece of wall in that heading follows the grain, given the heading of the piece before, if there is one.
bool follows(Grain grain, Heading heading, std::optional<Heading> last) {
  const auto quarters = static_cast<unsigned>(heading);
  switch (grain) {
    case Grain::row:
      return is_level(heading);
    case Grain::column:
      return !is_level(heading);
    case Grain::rising_stairs:
      return !last || quarters == (static_cast<unsigned>(*last) ^ 1U);
    case Grain::falling_stairs:
      break;
  }
  return !last || quarters == (static_cast<unsigned>(*last) ^ 3U);
}

bool has_wall(const MazeDraft& draft, Post post) {
  return std::any_of(all_headings.begin(), all_headings.end(),
                     [&](Heading heading) { return !draft.open_walls().contains(wall_from(post, heading)); });
}

}  // namespace

WallGrowth::WallGrowth(MazeDraft& draft, Rng& rng, const CellSet& barren)
    : draft_(draft), rng_(rng), standing_(barren), barren_(barren) {
  const auto [width, height] = draft.size();
  for (int y = 0; y <= height; ++y)
    for (int x = 0; x <= width; ++x) {
      const Post post{x, y};
      if (barren.contains(post) || (is_inner(post, draft.size()) && !has_wall(draft, post))) continue;
      standing_.insert(post);
      roots_.push_back(post);
    }
  for (int patch = 0; patch < std::max(1, draft.size().area() / cells_of_a_patch); ++patch) {
    const Post centre{rng.below(width), rng.below(height)};
    patches_.push_back({centre, static_cast<Grain>(rng.below(4))});
  }
}

std::vector<Heading> WallGrowth::free_headings(Post post) const {
  std::vector<Heading> headings;
  for (const Heading heading : all_headings)
    if (is_free(neighbour(post, heading))) headings.push_back(heading);
  return headings;
}

Grain WallGrowth::grain_at(Post post) const {
  const auto distance = [&](const Patch& patch) {
    const int dx = patch.centre.x - post.x;
    const int dy = patch.centre.y - post.y;
    return dx * dx + dy * dy;
  };
  const auto nearer = [&](const Patch& a, const Patch& b) { return distance(a) < distance(b); };
  return std::min_element(patches_.begin(), patches_.end(), nearer)->grain;
}

// A random free heading for the next piece of a wall, mostly along the grain. `last` is the heading of the piece
// before, if there is one.
Heading WallGrowth::choose(Post tip, std::optional<Heading> last, std::vector<Heading> free) {
  const Grain grain = grain_at(tip);
  std::vector<Heading> along;
  for (const Heading heading : free)
    if (follows(grain, heading, last)) along.push_back(heading);
  return draw(!along.empty() && rng_.chance(obedience, 100) ? along : free, rng_);
}

// Grows one wall from a standing post; false when no neighbouring post is free.
bool WallGrowth::grow_wall(Post root) {
  Post tip = root;
  std::optional<Heading> last;
  for (int length = 2 + rng_.below(longest_wall - 1); length > 0; --length) {
    std::vector<Heading> free = free_headings(tip);
    if (free.empty()) break;
    last = choose(tip, last, std::move(free));
    const Wall wall = wall_from(tip, *last);
    draft_.close(wall.cell, wall.side);
    tip = neighbour(tip, *last);
    standing_.insert(tip);
    roots_.push_back(tip);
  }
  return last.has_value();
}

void WallGrowth::plant_islands(int count) {
  std::vector<Post> lots;
  for (int y = 1; y < draft_.size().height; ++y)
    for (int x = 1; x < draft_.size().width; ++x) lots.emplace_back(x, y);
  while (count > 0 && !lots.empty()) {
    const Post post = draw(lots, rng_);
    if (!is_free(post) || free_headings(post).size() < 4) continue;
    standing_.insert(post);
    roots_.push_back(post);
    grow_wall(post);
    --count;
  }
}

// Mostly grows from the newest post: this makes few branches, and so few dead ends between them.
void WallGrowth::fill() {
  while (!roots_.empty()) {
    if (!rng_.chance(newest_first, 100))
      std::swap(roots_[static_cast<std::size_t>(rng_.below(static_cast<int>(roots_.size())))], roots_.back());
    const Post root = roots_.back();
    if (!grow_wall(root)) std::erase(roots_, root);
  }
}

}  // namespace labmouse
