// Wall growth: a maze made from its walls instead of its corridors.
//
// Method: walls grow from posts that have a wall to free posts, never to another one that has a wall. In the end every
// post has a wall, and no walls form a ring: all cells stay connected. Each island of walls that is not connected to
// the border adds a loop to the maze. Walls grow along the grain of their patch of the maze, rows, columns or stairs,
// so that neighbouring walls run side by side: long straights and zigzags.
// Limits: sides of at most 63 cells.
// Source: the wall-extending method (kabe-nobashi) of Japanese maze programming, folklore of the 1980s; the grain is
// our own.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/maze/post.hpp"

namespace labmouse {

/// The direction in which walls prefer to grow: along rows, along columns, or in stairs (north and east take turns, or
/// south and west: rising; north and west, or south and east: falling).
enum class Grain : std::uint8_t { row, column, rising_stairs, falling_stairs };

/// Grows walls in a draft. Posts of the border and posts with a wall count as standing from the beginning.
class WallGrowth {
 public:
  /// Draft and generator must outlive it. Walls neither start at a barren post nor reach it.
  WallGrowth(MazeDraft& draft, Rng& rng, const CellSet& barren);

  /// Adds up to `count` islands: each is a wall of at least one piece from a free post with four free neighbours.
  void plant_islands(int count);
  /// Grows walls until no free post next to a standing one is left.
  void fill();

 private:
  // The posts nearest to the centre have this grain.
  struct Patch {
    Post centre;
    Grain grain;
  };

  bool is_free(Post post) const { return is_inner(post, draft_.size()) && !standing_.contains(post); }
  std::vector<Heading> free_headings(Post post) const;
  Grain grain_at(Post post) const;
  Heading choose(Post tip, std::optional<Heading> last, std::vector<Heading> free);
  bool grow_wall(Post root);

  MazeDraft& draft_;
  Rng& rng_;
  CellSet standing_;
  CellSet barren_;
  std::vector<Post> roots_;  // standing posts from which a wall may still grow
  std::vector<Patch> patches_;
};

}  // namespace labmouse
