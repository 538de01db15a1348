// Lists of nodes that a search writes without asking: what a processor would have to foresee, and cannot in a maze that
// it has not met before, costs it more than a few words written in vain.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "labmouse/mouse/robot/tables.hpp"

namespace labmouse::drive {

/// The places of the ones in every byte, from the lowest on.
template <class Number>
struct Ones {
  Number places[256][8]{};
  std::uint8_t count[256]{};

  constexpr Ones() {
    for (unsigned byte = 0; byte < 256; ++byte)
      for (unsigned bit = 0; bit < 8; ++bit)
        if ((byte >> bit & 1U) != 0) places[byte][count[byte]++] = static_cast<Number>(bit);
  }
};

/// A list of numbers. More than is added is written behind its end.
template <class Number>
class List {
 public:
  explicit List(int most) : numbers_(new Number[static_cast<std::size_t>(most) + 8]) { clear(); }

  void clear() { end_ = numbers_.get(); }
  const Number* begin() const { return numbers_.get(); }
  const Number* end() const { return end_; }

  /// Adds a number once or not at all.
  void add(Number number, unsigned times) {
    *end_ = number;
    end_ += times;
  }
  /// Adds the sums of a number and the places of the ones of a byte.
  void add_ones(Number number, unsigned byte) {
    for (unsigned i = 0; i < 8; ++i) end_[i] = static_cast<Number>(number + ones.places[byte][i]);
    end_ += ones.count[byte];
  }

 private:
  static constexpr Ones<Number> ones{};

  std::unique_ptr<Number[]> numbers_;
  Number* end_;
};

/// Nodes that wait, by time, in buckets: those of one bucket in any order, so that it may fill again while it is
/// emptied (Dial 1969; Denardo and Fox 1979).
class Buckets {
 public:
  /// They are used in turn; what waits for a later time than they reach is visited with the last of them.
  static constexpr unsigned count = 64;

  /// For nodes with numbers below `nodes`.
  Buckets(int nodes, int shift) : shift_(shift), words_(static_cast<std::size_t>(nodes) / 64), sets_(count * words_) {}

  void clear() {
    for (unsigned bucket = 0; bucket < count; ++bucket)
      if (filled_[bucket] != 0) empty(bucket, [](int) {});
    current_ = last_ = 0;
  }
  /// Lets a node wait until a time, or until now if that has passed; never, where it is no_time or later.
  void add(int node, DriveTime time) {
    if (time >= no_time) return;
    const unsigned bucket = std::clamp(bucket_of(time), current_, current_ + count - 1);
    const std::size_t word = static_cast<std::size_t>(node) / 64;
    sets_[bucket % count * words_ + word] |= std::uint64_t{1} << node % 64;
    filled_[bucket % count] |= std::uint64_t{1} << word % 64;
    last_ = std::max(last_, bucket);
  }
  /// Goes on to the first bucket in which nodes wait, up to that of a time. Whether there is one.
  bool advance(DriveTime until) {
    for (const unsigned end = std::min(last_, bucket_of(until)); current_ <= end; ++current_)
      if (filled_[current_ % count] != 0) return true;
    return false;
  }
  /// Whether a node that waited for this time has been visited before the current bucket.
  bool passed(DriveTime time) const { return bucket_of(time) < current_; }
  /// Calls visit(node) for all nodes of the current bucket, and forgets them.
  template <class Visit>
  void empty(Visit visit) {
    empty(current_ % count, visit);
  }

 private:
  unsigned bucket_of(DriveTime time) const { return static_cast<unsigned>(time >> shift_); }

  template <class Visit>
  void empty(unsigned bucket, Visit visit) {
    std::uint64_t* const set = &sets_[bucket * words_];
    for (std::uint64_t filled = std::exchange(filled_[bucket], 0); filled != 0; filled &= filled - 1)
      for (auto word = static_cast<std::size_t>(std::countr_zero(filled)); word < words_; word += 64)
        for (std::uint64_t nodes = std::exchange(set[word], 0); nodes != 0; nodes &= nodes - 1)
          visit(static_cast<int>(64 * word) + std::countr_zero(nodes));
  }

  int shift_;
  std::size_t words_;  ///< of a set
  unsigned current_ = 0;
  unsigned last_ = 0;  ///< in which a node has been put
  std::vector<std::uint64_t> sets_;
  std::array<std::uint64_t, count> filled_{};  ///< words that are not empty, modulo 64
};

}  // namespace labmouse::drive
