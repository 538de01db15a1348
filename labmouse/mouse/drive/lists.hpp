// Lists of nodes that a search writes without branches: in a new maze, branches that a processor predicts wrongly cost
// more than a few unused writes.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "labmouse/mouse/robot/tables.hpp"

namespace labmouse::drive {

/// The positions of the bits that are set in each byte, lowest first.
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

/// A list of up to `Most` numbers in its own memory. Additions may write a few unused numbers behind its end.
template <class Number, int Most>
class List {
 public:
  List() = default;
  List(const List&) = delete;
  List& operator=(const List&) = delete;

  void clear() { end_ = numbers_; }
  const Number* begin() const { return numbers_; }
  const Number* end() const { return end_; }
  bool empty() const { return end_ == numbers_; }
  /// Whether there is room for so many more.
  bool takes(int more) const { return end_ - numbers_ <= Most - more; }

  /// Adds a number if `times` is 1; does not if it is 0.
  void add(Number number, unsigned times) {
    *end_ = number;
    end_ += times;
  }
  /// Adds, for each bit that is set in a byte, the number plus the bit's position.
  void add_ones(Number number, unsigned byte) {
    for (unsigned i = 0; i < 8; ++i) end_[i] = static_cast<Number>(number + ones.places[byte][i]);
    end_ += ones.count[byte];
  }

 private:
  static constexpr Ones<Number> ones{};

  Number numbers_[Most + 8];
  Number* end_ = numbers_;
};

/// A set of nodes, as bits by line, that is emptied line by line.
template <class Word, int Lines>
class NodeSet {
 public:
  static constexpr int points = 8 * static_cast<int>(sizeof(Word));

  /// Adds nodes of one line: a bit's position is that of the node on the line.
  void add(int line, Word nodes) {
    lines_.add(static_cast<std::uint16_t>(line),
               static_cast<unsigned>(nodes_[line] == 0) & static_cast<unsigned>(nodes != 0));
    nodes_[line] |= nodes;
  }
  /// Calls visit(node) for all nodes, and removes them; visit must not add any. A few are listed before they are
  /// visited.
  template <class Visit>
  void empty(Visit visit) {
    List<std::uint16_t, 128> some;
    const auto visit_some = [&] {
      for (const int node : some) visit(node);
      some.clear();
    };
    for (const int line : lines_) {
      const Word nodes = std::exchange(nodes_[line], Word{0});
      for (int byte = 0; byte < points; byte += 8)
        some.add_ones(static_cast<std::uint16_t>(line * points + byte), static_cast<unsigned>(nodes >> byte) & 255U);
      if (!some.takes(points)) visit_some();
    }
    lines_.clear();
    visit_some();
  }

 private:
  Word nodes_[Lines]{};
  List<std::uint16_t, Lines> lines_;  ///< those with nodes
};

/// A bucket queue of numbers below `Nodes`, by time. Those of one bucket come in any order, so that it may fill again
/// while it is emptied (Dial 1969; Denardo and Fox 1979).
template <int Nodes, unsigned Count>
class Buckets {
 public:
  /// Buckets are used in turn. Times beyond their range are put into the last of them.
  static constexpr unsigned count = Count;

  explicit Buckets(int shift) : shift_(shift) {}

  void clear() {
    for (unsigned bucket = 0; bucket < count; ++bucket)
      if (filled_[bucket] != 0) empty(bucket, [](int) {});
    current_ = last_ = 0;
  }
  /// Queues a node for a time, or for now if that has passed; not at all for no_time or later. Forced inline: without
  /// it compilers make a call, which costs a search 3 %.
  [[gnu::always_inline]] void add(int node, DriveTime time) {
    if (time >= no_time) return;
    const unsigned bucket = std::clamp(bucket_of(time), current_, current_ + count - 1);
    const std::size_t word = static_cast<std::size_t>(node) / 64;
    sets_[bucket % count][word] |= std::uint64_t{1} << node % 64;
    filled_[bucket % count] |= std::uint64_t{1} << word % 64;
    last_ = std::max(last_, bucket);
  }
  /// Advances to the first bucket with nodes, at most to that of a time; false if there is none.
  bool advance(DriveTime until) {
    for (const unsigned end = std::min(last_, bucket_of(until)); current_ <= end; ++current_)
      if (filled_[current_ % count] != 0) return true;
    return false;
  }
  /// Whether a time lies before the current bucket, so that its nodes have been visited.
  bool passed(DriveTime time) const { return bucket_of(time) < current_; }
  /// Whether a time lies in the current bucket.
  bool is_now(DriveTime time) const { return bucket_of(time) == current_; }
  /// Calls visit(node) for all nodes of the current bucket, and removes them. It may add others meanwhile.
  template <class Visit>
  void empty(Visit visit) {
    empty(current_ % count, visit);
  }

 private:
  static constexpr std::size_t words = Nodes / 64;  ///< in the bit set of a bucket

  unsigned bucket_of(DriveTime time) const { return static_cast<unsigned>(time >> shift_); }

  template <class Visit>
  void empty(unsigned bucket, Visit visit) {
    std::uint64_t* const set = sets_[bucket];
    for (std::uint64_t filled = std::exchange(filled_[bucket], 0); filled != 0; filled &= filled - 1)
      for (auto word = static_cast<std::size_t>(std::countr_zero(filled)); word < words; word += 64)
        for (std::uint64_t nodes = std::exchange(set[word], 0); nodes != 0; nodes &= nodes - 1)
          visit(static_cast<int>(64 * word) + std::countr_zero(nodes));
  }

  int shift_;
  unsigned current_ = 0;
  unsigned last_ = 0;  ///< the last one that has been filled
  std::uint64_t sets_[count][words]{};
  std::uint64_t filled_[count]{};  ///< by bucket: the words that are not 0, modulo 64
};

/// The least times from a start to all nodes, in 16 bits each: rounded down to a unit that makes the latest one fit.
template <int Nodes>
class Bounds {
 public:
  /// Takes time_of(node) for all nodes; times of no_time count as the latest other one.
  template <class TimeOf>
  void set(TimeOf time_of) {
    DriveTime latest = 0;
    for (int node = 0; node < Nodes; ++node)
      if (const DriveTime time = time_of(node); time < no_time) latest = std::max(latest, time);
    shift_ = std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint32_t>(latest))) - 16);
    for (int node = 0; node < Nodes; ++node)
      times_[node] = static_cast<std::uint16_t>(std::min(time_of(node), latest) >> shift_);
  }
  DriveTime operator[](int node) const { return DriveTime{times_[node]} << shift_; }
  /// By how much a stored time may be below the true one.
  DriveTime error() const { return (DriveTime{1} << shift_) - 1; }

 private:
  int shift_ = 0;
  std::uint16_t times_[Nodes]{};
};

/// No bounds: every time may be 0.
struct NoBounds {
  DriveTime operator[](int) const { return 0; }
  DriveTime error() const { return 0; }
};

}  // namespace labmouse::drive
