// The least search times from every place to a set of cells.
//
// Method: Dijkstra with buckets, backwards from the cells, over the edges by which cells are entered, one for each
// heading. A field in its own memory is repaired if little has changed since it was filled (Koenig, Likhachev and Furcy
// 2004, without a heuristic): an edge whose time is no longer that by its best move is inconsistent, and queued for the
// earlier of these two times. When it is taken and the move is earlier, it gets the time of the move. If the move is
// later, its time is reset to no_time, and it is queued again for the time of the move.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/drive/edge_buckets.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/wall_prices.hpp"

namespace labmouse {

/// How a strategy prices the moves of a search through walls that it has not seen.
struct SearchTolls {
  SearchDrive drive;                ///< the moves
  DriveTime unit = 0;               ///< microseconds for each unit of an unseen wall's price
  DriveTime base = 0;               ///< microseconds for each wall that has a price
  int closed = WallPrices::closed;  ///< a wall of this price or more counts as closed
  /// Microseconds that entering a cell saves, by the cell's index; a move still takes at least one. It has an element
  /// for each cell, 0 for known ones, or is empty. It must outlive the field's use.
  std::span<const DriveTime> savings = {};
};

/// Times in microseconds to enter any of some cells by the moves of a search. Steps that end at rest are not used, but
/// a mouse at rest may pivot first. Takes all memory that it will need.
class SearchField {
 public:
  /// In its own memory: faster if the fills of a field differ little.
  /// @param size of the maze, with sides of at most max_drive_side cells.
  /// @param drive the moves; the times of cell, turn and back must be more than 0.
  SearchField(Size size, const SearchDrive& drive);
  /// In the caller's memory.
  /// @param size of the maze, with sides of at most max_drive_side cells.
  /// @param drive the moves; the times of cell, turn and back must be more than 0.
  /// @param memory at least bytes_for(size) bytes, beginning at a multiple of four. It must outlive it.
  SearchField(Size size, const SearchDrive& drive, std::span<std::byte> memory);
  /// Whether it is in its own memory, so that no other field overwrites it.
  bool keeps() const { return own_ != nullptr; }
  /// Bytes of memory that a field for a maze takes, if the memory is the caller's.
  /// @param size of the maze, with sides of at most max_drive_side cells.
  static std::size_t bytes_for(Size size);

  /// Finds the times over open walls to some cells, with dashes over known cells.
  /// @param passages the open walls, all inside the size.
  /// @param known cells whose walls are all known.
  /// @param targets the cells to enter, all inside the size; without any, all times are no_time.
  /// @param place null for all times; otherwise it finds only what from() and step() need there and at the places that
  ///   its steps lead to.
  void fill(const WallSet& passages, const CellSet& known, const CellSet& targets, const SearchPlace* place = nullptr) {
    fill(drive_, passages, known, targets, place);
  }
  /// The same with other times of moves, which from() and step() use, too, until the next fill.
  /// @param moves the times of the moves cell, turn and back; the others are those of the constructor.
  /// @param passages the open walls, all inside the size.
  /// @param known cells whose walls are all known.
  /// @param targets the cells to enter, all inside the size.
  /// @param place as above.
  void fill(const SearchDrive& moves, const WallSet& passages, const CellSet& known, const CellSet& targets,
            const SearchPlace* place = nullptr);
  /// The same over all walls that are not closed, of which unseen ones cost more. from() and step() use these tolls,
  /// too, until the next fill.
  /// @param prices of the walls.
  /// @param tolls the moves, and what prices cost.
  /// @param known cells whose walls are all known.
  /// @param targets the cells to enter, all inside the size.
  /// @param place as above.
  void fill(const WallPrices& prices, const SearchTolls& tolls, const CellSet& known, const CellSet& targets,
            const SearchPlace* place = nullptr);

  /// The time from a place to the targets.
  /// @param place inside the maze; if the last fill had a place, that one or one that its steps lead to.
  /// @return microseconds, with tolls; 0 in a target, no_time if none of them can be reached.
  DriveTime from(const SearchPlace& place) const;
  /// The first move of a fastest way from a place, over one edge or a dash. Ties: straight on with the fewest edges, to
  /// the left, to the right, back.
  /// @param place as for from().
  /// @return a step; Action::step(0, 0) in a target, a forfeit with `no_route` if there is no way.
  Action step(const SearchPlace& place) const;

 private:
  /// The price of a closed wall.
  static constexpr std::uint8_t closed = 0xff;

  struct Move {
    int quarters;
    int cells;
    DriveTime time;
  };

  /// `due_bytes` is the size of due_ at the beginning of the memory; 0 if it is the same as times_.
  SearchField(Size size, const SearchDrive& drive, std::byte* memory, std::size_t due_bytes);
  static std::size_t due_bytes(Size size);

  std::size_t edge_of(Cell cell, Heading heading) const {
    return static_cast<std::size_t>(4 * size_.index(cell) + static_cast<int>(heading));
  }
  Pose pose_of(std::size_t edge) const { return {size_.cell_at(static_cast<int>(edge / 4)), all_headings[edge % 4]}; }
  std::size_t ahead_of(std::size_t edge) const { return edge + ahead_[edge % 4]; }
  template <class Price>
  void set_prices(const SearchTolls& tolls, Price price);
  void set_price(Wall wall, std::uint8_t price);
  /// Whether an edge cannot be passed; that of the border never can.
  bool is_shut_behind(std::size_t edge) const;
  DriveTime toll(std::size_t edge) const;
  DriveTime shortest_move() const;
  DriveTime bucket_width() const;
  void begin(const CellSet& known, const CellSet& targets);
  void search(const SearchPlace* place);
  void reach(std::size_t edge, DriveTime time);
  void take(std::size_t edge);
  void expand(std::size_t edge);
  template <class Visit>
  void for_each_before(std::size_t edge, Visit visit) const;
  template <class Visit>
  void for_each_dash_before(std::size_t edge, Visit visit) const;
  void repair(const WallSet& passages, const CellSet& known, const CellSet& targets);
  void repair_walls(const WallSet& passages);
  void repair_dashes(Cell cell);
  void repair_before(std::size_t edge);
  void repair(std::size_t edge);
  DriveTime best_of(std::size_t edge) const;
  bool leads_to(const SearchPlace& place, std::size_t edge) const;
  DriveTime through(const SearchPlace& place, const Move& move) const;
  template <class Visit>
  void for_each_move(const SearchPlace& place, Visit visit) const;
  template <class Visit>
  void for_each_dash(const Pose& edge, Visit visit) const;

  Size size_;
  SearchDrive drive_;
  std::array<std::size_t, 4> ahead_;
  CellSet known_;
  CellSet targets_;
  /// With its own memory: the passages of the last fill.
  std::unique_ptr<WallSet> passages_;
  bool repairable_ = false;
  std::unique_ptr<std::byte[]> own_;  ///< null if the memory is the caller's
  /// By edge_of: the time from the edge by which the cell is entered in that heading.
  DriveTime* times_;
  /// By edge_of: the time that an edge is queued for. Without its own memory these are its times.
  DriveTime* due_;
  /// By edge_of, for leaving the cell in that heading: the cost besides the time, in units, or `closed`.
  std::uint8_t* prices_;
  SearchTolls tolls_;
  EdgeBuckets queue_;
};

}  // namespace labmouse
