// What the two searches behind FastestRoutes have in common: one for robots of one speed, one for robots of many.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/drive/lattice.hpp"
#include "labmouse/mouse/drive/tables.hpp"

namespace labmouse::drive {

/// A search over the lattice. Labels are times to the goals: of a turn that begins at a node in a lane, and of a straight
/// that begins there behind a turn that ended in a lane. Directions are those of driving.
class Search {
 public:
  virtual ~Search() = default;
  virtual void fill(Size size, const WallSet& passages, const CellSet& goals) = 0;
  virtual DriveTime turning(int node, std::size_t lane) const = 0;
  virtual DriveTime rolling(int node, std::size_t lane) const = 0;
  virtual int node(HalfPoint point, int direction) const = 0;
  virtual HalfPoint point(int node) const = 0;
  virtual bool passable(HalfPoint point) const = 0;
  /// Calls no more than: the node behind the turn of a bit that can begin at a node; -1 where it cannot.
  virtual int leap(int node, unsigned bit) const = 0;
};

/// Labels that wait, by time, in buckets as wide as a turn at most: those of one bucket do not depend on each other, so any
/// order will do (Denardo and Fox 1979; Dial 1969). A node waits at most once in each bucket.
class Buckets {
 public:
  /// More than the longest straight can last in any robot that DriveTables allow (longest_edge).
  static constexpr unsigned count = 256;

  /// For nodes with numbers below `nodes`. The lists do not lie a power of two apart, which caches dislike.
  Buckets(int nodes, int shift)
      : shift_(shift), stride_(static_cast<std::size_t>(nodes) + 72), waiting_(new std::uint16_t[count * stride_]) {}

  void clear() {
    lengths_.fill(0);
    filled_.fill(0);
  }
  unsigned bucket(DriveTime time) const { return static_cast<unsigned>(time >> shift_); }
  /// Adds a node to a bucket if so asked, and writes it down in any case: a branch that nobody can foresee costs more.
  void add_if(bool wanted, unsigned bucket, int node) {
    const unsigned slot = bucket % count;
    waiting_[slot * stride_ + lengths_[slot]] = static_cast<std::uint16_t>(node);
    lengths_[slot] += wanted ? 1U : 0U;
    filled_[slot / 64] |= std::uint64_t{wanted} << slot % 64;
  }
  /// The first bucket from one on that is not empty; none where all are.
  unsigned next(unsigned from) const {
    const unsigned slot = from % count;
    const std::uint64_t rest = filled_[slot / 64] >> slot % 64;
    if (rest != 0) return from + static_cast<unsigned>(std::countr_zero(rest));
    for (unsigned word = 1; word <= count / 64; ++word)
      if (const std::uint64_t filled = filled_[(slot / 64 + word) % (count / 64)]; filled != 0)
        return from + 64 * word - slot % 64 + static_cast<unsigned>(std::countr_zero(filled));
    return none;
  }
  static constexpr unsigned none = ~0U;
  const std::uint16_t* begin(unsigned bucket) const { return &waiting_[bucket % count * stride_]; }
  unsigned length(unsigned bucket) const { return lengths_[bucket % count]; }
  void empty(unsigned bucket) {
    lengths_[bucket % count] = 0;
    filled_[bucket % count / 64] &= ~(std::uint64_t{1} << bucket % 64);
  }

 private:
  int shift_;
  std::size_t stride_;
  std::array<unsigned, count> lengths_{};
  std::array<std::uint64_t, count / 64> filled_{};
  std::unique_ptr<std::uint16_t[]> waiting_;
};

/// The greatest power of two that is not above the shortest turn, as an exponent.
int bucket_shift(const DriveTables& tables);

std::unique_ptr<Search> make_fixed_search(Size size, const DriveTables& tables);
std::unique_ptr<Search> make_lane_search(Size size, const DriveTables& tables);

}  // namespace labmouse::drive
