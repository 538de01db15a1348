// The least search times from every place to a set of cells.
//
// Method: Dijkstra with a heap, backwards from the cells, over the edges by which cells are entered, one for each
// heading.
#pragma once

#include <cstdint>
#include <vector>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/wall_prices.hpp"

namespace labmouse {

/// Times in microseconds to enter any of some cells by the moves of a search; a pivot on the way is none of them, but
/// for that of a mouse at rest. Takes all memory that it will need.
class SearchField {
 public:
  /// Times of moves are more than 0.
  SearchField(Size size, const SearchDrive& drive);

  /// Finds all times over the given passages (all inside the size) to the given cells.
  void fill(const WallSet& passages, const CellSet& targets);
  /// The same over walls that are not closed, where each unit of a wall's price counts as so many microseconds.
  void fill(const WallPrices& prices, DriveTime unit, const CellSet& targets);

  /// The time from a place; 0 in the cells themselves, no_time where none of them can be reached.
  DriveTime from(const SearchPlace& place) const;
  /// The first move of a fastest way from a place, over one edge: of equally fast ones straight on, to the left, to the
  /// right, back. In one of the cells already it stays, as Action::step(0, 0); where there is no way it forfeits.
  Action step(const SearchPlace& place) const;

 private:
  struct Waiting {
    DriveTime time;
    std::int32_t edge;
  };
  struct Move {
    int quarters;
    DriveTime time;
  };

  std::size_t edge_of(Cell cell, Heading heading) const {
    return static_cast<std::size_t>(4 * size_.index(cell) + static_cast<int>(heading));
  }
  template <class Toll>
  void set_tolls(Toll toll);
  void search(const CellSet& targets);
  void reach(std::size_t edge, DriveTime time);
  void expand(Pose pose, DriveTime time);
  DriveTime through(const SearchPlace& place, const Move& move) const;
  template <class Visit>
  void for_each_move(const SearchPlace& place, Visit visit) const;

  Size size_;
  SearchDrive drive_;
  CellSet targets_;
  /// By edge_of: what leaving the cell in that heading costs besides the time, no_time where it is closed.
  std::vector<DriveTime> tolls_;
  /// By edge_of: the time from the edge by which the cell is entered in that heading.
  std::vector<DriveTime> times_;
  std::vector<Waiting> heap_;
};

}  // namespace labmouse
