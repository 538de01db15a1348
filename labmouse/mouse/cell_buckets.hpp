// A priority queue of cells by cost: a ring of buckets (Dial 1969), one for each cost that may still come. A bucket is
// a linked list of cell indices; a row of bits says which buckets are not empty.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace labmouse {

/// Queued cells, the cheapest first. A cell is queued at most once; all queued costs differ by less than the length of
/// the ring. Empty between two searches, so that several may share one.
class CellBuckets {
 public:
  /// For cell indices below `cells`. A new cost exceeds that of the last cell taken by at most `dearest`.
  CellBuckets(int cells, int dearest) {
    const auto buckets = std::max(64U, std::bit_ceil(static_cast<unsigned>(dearest) + 1));
    mask_ = buckets - 1;
    links_.assign(static_cast<std::size_t>(cells), {none, none});
    first_.assign(buckets, none);
    used_.assign(buckets / 64, 0);
  }

  void insert(int cell, int cost) {
    const std::size_t bucket = bucket_of(cost);
    const Index second = first_[bucket];
    links_[static_cast<std::size_t>(cell)] = {none, second};
    if (second != none) links_[second].before = static_cast<Index>(cell);
    first_[bucket] = static_cast<Index>(cell);
    used_[bucket / 64] |= std::uint64_t{1} << bucket % 64;
  }

  /// Removes a cell that is queued at that cost.
  void erase(int cell, int cost) {
    const Link link = links_[static_cast<std::size_t>(cell)];
    if (link.next != none) links_[link.next].before = link.before;
    if (link.before != none)
      links_[link.before].next = link.next;
    else
      begin_with(bucket_of(cost), link.next);
  }

  /// Raises a cost to the lowest queued one, at most once around the ring; false if nothing is queued.
  bool find(int& cost) const {
    const int words = static_cast<int>(used_.size()), begin = static_cast<int>(bucket_of(cost));
    std::uint64_t word = used_[static_cast<std::size_t>(begin / 64)] & ~std::uint64_t{0} << begin % 64;
    for (int ahead = 0; ahead <= words; ++ahead) {
      const int at = begin / 64 + ahead;
      if (ahead > 0) word = used_[static_cast<std::size_t>(at & (words - 1))];
      if (word == 0) continue;
      cost += at * 64 + std::countr_zero(word) - begin;
      return true;
    }
    return false;
  }

  /// Removes and returns a cell that is queued at that cost; there must be one.
  int take(int cost) {
    const std::size_t bucket = bucket_of(cost);
    const Index cell = first_[bucket], second = links_[cell].next;
    if (second != none) links_[second].before = none;
    begin_with(bucket, second);
    return cell;
  }

 private:
  using Index = std::uint16_t;
  /// No cell.
  static constexpr Index none = 0xFFFF;
  /// The neighbours in a bucket's list.
  struct Link {
    Index before, next;
  };

  std::size_t bucket_of(int cost) const { return static_cast<unsigned>(cost) & mask_; }
  void begin_with(std::size_t bucket, Index cell) {
    first_[bucket] = cell;
    if (cell == none) used_[bucket / 64] &= ~(std::uint64_t{1} << bucket % 64);
  }

  std::size_t mask_;                 ///< buckets in the ring, less one
  std::vector<Link> links_;          ///< of each queued cell
  std::vector<Index> first_;         ///< the first cell of each bucket
  std::vector<std::uint64_t> used_;  ///< which buckets hold cells
};

}  // namespace labmouse
