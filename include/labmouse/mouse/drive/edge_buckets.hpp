// A priority queue of edges of a maze, by time: a ring of buckets (Dial 1969; Denardo and Fox 1979).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "labmouse/mouse/robot/tables.hpp"

namespace labmouse {

/// A queue of edges, exact up to the width of a bucket. A bucket is a linked list of edges. Each edge is queued at most
/// once. Times outside the range of the ring are allowed: when an edge of a later time is found, it moves on.
class EdgeBuckets {
 public:
  /// The link of an edge that is not queued. Numbers of edges are below first_of_bucket.
  static constexpr std::uint16_t nowhere = 0xffff;
  static constexpr std::uint16_t first_of_bucket = 0x8000;

  /// Without room for any edge.
  EdgeBuckets() = default;
  /// Uses arrays of the caller, one element an edge, which must outlive it. Call clear() before all else.
  /// @param before for the link of each edge to the one before it in its bucket.
  /// @param next for the link to the next one.
  /// @param times by edge, in microseconds; the caller writes them, the least comes first.
  EdgeBuckets(std::uint16_t* before, std::uint16_t* next, const DriveTime* times)
      : before_(before), next_(next), times_(times) {}

  /// Empties the queue.
  /// @param edges the number of all edges.
  /// @param width the greatest width of a bucket, in microseconds, at least 1.
  void clear(std::size_t edges, DriveTime width) {
    std::fill(before_, before_ + edges, nowhere);
    filled_ = 0;
    current_ = 0;
    shift_ = static_cast<int>(std::bit_width(static_cast<std::uint32_t>(width))) - 1;
  }
  /// Whether an edge is queued.
  /// @param edge its number, below that of all edges.
  bool contains(std::size_t edge) const { return before_[edge] != nowhere; }
  /// Inserts an edge, or moves it after its time has changed.
  /// @param edge its number, below that of all edges.
  void put(std::size_t edge) {
    remove(edge);
    const unsigned bucket = bucket_of(edge);
    current_ = std::min(current_, bucket);
    const unsigned place = std::min(bucket, current_ + count - 1) % count;
    const bool alone = (filled_ >> place & 1U) == 0;
    filled_ |= std::uint64_t{1} << place;
    before_[edge] = static_cast<std::uint16_t>(first_of_bucket + place);
    next_[edge] = alone ? nowhere : first_[place];
    if (!alone) before_[first_[place]] = static_cast<std::uint16_t>(edge);
    first_[place] = static_cast<std::uint16_t>(edge);
  }
  /// Removes an edge, if it is queued.
  /// @param edge its number, below that of all edges.
  void remove(std::size_t edge) {
    const std::uint16_t before = before_[edge];
    if (before == nowhere) return;
    const std::uint16_t next = next_[edge];
    before_[edge] = nowhere;
    if (next != nowhere) before_[next] = before;
    if (before < first_of_bucket) {
      next_[before] = next;
      return;
    }
    const unsigned place = before - first_of_bucket;
    first_[place] = next;
    if (next == nowhere) filled_ &= ~(std::uint64_t{1} << place);
  }
  /// Finds the first bucket with edges.
  /// @param until in microseconds.
  /// @return whether that bucket begins at this time or earlier. Then take() gives an edge of it.
  bool find(DriveTime until) {
    while (filled_ != 0) {
      const unsigned next =
          current_ + static_cast<unsigned>(std::countr_zero(std::rotr(filled_, static_cast<int>(current_ % count))));
      if (next > static_cast<unsigned>(until) >> shift_) return false;
      current_ = next;
      const std::size_t edge = first_[next % count];
      if (bucket_of(edge) <= next) return true;
      put(edge);
    }
    return false;
  }
  /// Removes and returns an edge of the bucket that find() has found.
  std::size_t take() {
    const std::size_t edge = first_[current_ % count];
    remove(edge);
    return edge;
  }

 private:
  static constexpr unsigned count = 64;

  unsigned bucket_of(std::size_t edge) const { return static_cast<unsigned>(times_[edge]) >> shift_; }

  std::uint16_t* before_ = nullptr;  ///< by edge; of the first one of a bucket: first_of_bucket + its place in the ring
  std::uint16_t* next_ = nullptr;    ///< by edge
  const DriveTime* times_ = nullptr;
  std::array<std::uint16_t, count> first_{};
  std::uint64_t filled_ = 0;  ///< the buckets with edges
  unsigned current_ = 0;      ///< no edge is queued before this bucket
  int shift_ = 0;
};

}  // namespace labmouse
