// Approximate costs of the best run from start to goal through each cell.
//
//   start ... A(e) ... | e | ... V(e) ... goal
//
// The best run through a cell costs the least A(e) + V(e) of the edges e by which the cell is entered.
//
// A and V are the least sums of RunPrices and of the costs of unseen walls. Method: Bellman-Ford, forwards and
// backwards, over the edges by which cells are entered, each with the turn right before it. The queue is a set of bits,
// so that it takes little more memory than the result. What cannot be part of a run below the limit is left out:
// forwards by a lower bound of the rest, backwards by A.
//
// Limits: runs of 65.5 s or more are left out; prices count in steps of 4, and up to 1020 on each side of a cell.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "labmouse/mouse/drive/run_prices.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/wall_prices.hpp"

namespace labmouse {

/// What unseen walls cost a run. Their prices are -ln P(open) in units of 1/32 nat.
struct RunTolls {
  int per_nat = 0;                  ///< milliseconds for a price of 32
  int base = 0;                     ///< milliseconds for each wall that has a price
  int closed = WallPrices::closed;  ///< a wall of this price or more counts as closed
};

/// A run that may exist.
struct OptimisticRun {
  int time = 0;   ///< milliseconds, with RunTolls::base for each unseen wall, but without RunTolls::per_nat
  int price = 0;  ///< of all its unseen walls, in units of 1/32 nat
};

/// The costs of the best runs through the cells of a maze, in milliseconds.
class RunCosts {
 public:
  /// In the caller's memory.
  /// @param size of the maze.
  /// @param memory at least bytes_for(size) bytes, beginning at a multiple of two. It must outlive it.
  RunCosts(Size size, std::span<std::byte> memory);
  /// Bytes of memory that it takes for a maze.
  /// @param size of the maze, with an area of at most largest_area.
  static std::size_t bytes_for(Size size);
  /// The largest area of a maze, in cells: larger ones would take more memory than a chip has for a strategy.
  static constexpr int largest_area = 256;

  /// Sets what runs cost, and where they begin and end. Call it before all else.
  /// @param run milliseconds by edge, each at least 1.
  /// @param start inside the maze; a run begins straight on, in its heading.
  /// @param goals cells inside the maze, at least one.
  void aim(const RunPrices& run, Pose start, const CellSet& goals);
  /// Finds the time of the best run over open walls alone. It overwrites what plan() found.
  /// @param walls those with a price above 0 count as closed.
  /// @return milliseconds; 0 if the start is a goal, no_run if there is no run.
  int known(const WallPrices& walls);
  /// The time of no run, and the upper limit of all.
  static constexpr int no_run = 0xffff;
  /// Finds A and V of all runs that cost less than a limit.
  /// @param walls the prices of walls, -ln P(open) in units of 1/32 nat.
  /// @param tolls what unseen walls cost.
  /// @param limit milliseconds; more than no_run counts as no_run.
  void plan(const WallPrices& walls, const RunTolls& tolls, int limit);
  /// The run with the least cost through a cell.
  /// @param cell inside the maze, other than that of the start.
  /// @return nullopt if no run through it costs less than the limit of the plan.
  /// @pre plan() was the last search.
  std::optional<OptimisticRun> through(Cell cell) const;

 private:
  /// The turn by which the cell before was left.
  enum Last : unsigned { straight, left, right };
  static constexpr std::size_t lasts = 3;
  static constexpr int price_step = 4;
  /// By state: the least cost in milliseconds, and the sum of prices in that, in steps.
  struct Field {
    std::uint16_t* costs = nullptr;
    std::uint8_t* prices = nullptr;
  };

  std::size_t states() const { return 4 * lasts * static_cast<std::size_t>(size_.area()); }
  /// The first of the four edges by which a cell is entered; it also is the first of its four walls.
  std::size_t edges_of(Cell cell) const { return 4 * static_cast<std::size_t>(size_.index(cell)); }
  void set_walls(const WallPrices& walls, const RunTolls& tolls);
  int toll(int steps) const { return steps == 0 ? 0 : tolls_.base + steps * price_step * tolls_.per_nat / 32; }
  void find_least();
  void clear(Field& field, int limit);
  void reach(Field& field, std::size_t number, int cost, int steps);
  void reach_from_start(std::size_t edge, std::size_t last, int cost, int steps);
  void reach_to_goal(std::size_t edge, std::size_t last, int cost, int steps);
  void go_on(std::size_t number);
  void go_back(std::size_t number);
  void begin();
  template <class Expand>
  void search(Expand expand);

  Size size_;
  RunPrices run_;
  Pose start_;
  CellSet goals_;
  std::array<std::array<int, lasts>, lasts> costs_{};  ///< of an edge, by the turns before it and at it
  std::array<std::size_t, 4> ahead_;                   ///< from an edge to the next one ahead, by heading
  RunTolls tolls_;
  std::array<int, WallPrices::highest / price_step + 1> tolls_of_steps_{};
  int limit_ = no_run;
  Field from_start_, to_goal_;
  std::uint16_t* waiting_ = nullptr;  ///< by state, a bit: whether it is to be expanded
  /// By word of these, a bit: whether any bit of it is set.
  std::array<std::uint64_t, 4 * lasts * largest_area / 16 / 64> filled_{};
  std::uint16_t* least_ = nullptr;  ///< by cell: a lower bound of what a run costs from there on
  std::uint8_t* walls_ = nullptr;   ///< by cell and side: the price of the wall in steps, or closed
};

}  // namespace labmouse
