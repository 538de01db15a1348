// Distance fields, i.e. least costs from a set of cells to all cells, computed on rows of bits.
//
// A set of cells is one integer a row, and the rows are lanes of a vector. One layer of a breadth-first search is then
// a few vector instructions for all cells at once:
//
//     next = unreached & ( north1 & up(last, 1)   | north2 & up(last, 2)   | north3 & up(last, 3)
//                        | east1 & (last << 1)    | east2 & (last << 2)    | ...                )
//
// where north2 holds the cells that can be entered by a straight move of two cells northwards, and so on.
//
// The distances themselves are kept as planes of bits: bit y,x of plane k is bit k of the distance of cell (x,y). All
// cells not yet reached count up together, layer by layer; a binary counter flips two bits a step on average, so the
// bookkeeping costs two vector instructions a layer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/motion.hpp"

namespace labmouse {

struct FieldOrder;

/// The distance of a cell that cannot be reached: larger than any real one, and safe to add to.
inline constexpr int unreachable = 1 << 24;

/// Cheapest costs from a set of cells to every cell, under a motion table. Moves can be made both ways at the same
/// cost, so these are the costs to the set as well.
class DistanceField {
 public:
  /// Which kernel is used: the widest that the processor supports, or the portable one (for comparison).
  enum class Path : std::uint8_t { widest, portable };

  /// Takes all memory that it will need: with strides(), 0.4 KiB at 16×16, 1.8 KiB at 32×32 and 8 KiB at 64×64.
  /// @param size of the maze, with sides of 1 to max_side cells.
  /// @param motion the moves and their costs; must be valid.
  /// @param path the kernel; it has no effect on the distances.
  DistanceField(Size size, const Motion& motion, Path path = Path::widest);

  /// Computes the field.
  /// @param passages the open walls, all inside the size.
  /// @param from the cells at distance 0, all inside the size; without any, no cell is reached.
  void fill(const WallSet& passages, const CellSet& from);

  /// Distance of a cell.
  /// @param cell any cell.
  /// @return in the motion's unit; `unreachable` if no route leads there, and for cells outside the maze.
  /// @pre fill() was called.
  int at(Cell cell) const;
  /// Whether a route leads to a cell.
  /// @param cell any cell; false outside of the maze.
  /// @pre fill() was called.
  bool reaches(Cell cell) const { return at(cell) < unreachable; }
  /// All cells that can be reached, those at distance 0 among them.
  /// @pre fill() was called.
  CellSet reached() const;
  /// Writes the distances of all cells.
  /// @param out exactly size().area() elements; that of a cell is at size().index(cell), in the motion's unit, or
  ///   `unreachable`.
  /// @pre fill() was called.
  void copy_to(std::span<int> out) const;

  /// The moves that it was made for.
  const Motion& motion() const { return motion_; }
  /// The size of the maze that it was made for.
  Size size() const { return size_; }

 private:
  struct alignas(64) Block {
    std::uint64_t words[8];
  };
  /// The sets have rows of 16, 32 or 64 bits, depending on the size of the maze; these read the rows as that Word.
  template <class Word>
  int read(Cell cell) const;
  template <class Word>
  void read_all(std::span<int> out) const;
  template <class Word>
  CellSet read_reached() const;
  std::uint64_t* sets() { return storage_.data()->words; }
  const std::uint64_t* sets() const { return storage_.data()->words; }

  Size size_;
  Motion motion_;
  int row_bits_;
  int planes_;
  void (*kernel_)(const FieldOrder&);
  /// The unreached cells, then the planes, then scratch memory of the kernel: sets of rows of row_bits_ bits.
  std::vector<Block> storage_;
};

}  // namespace labmouse
