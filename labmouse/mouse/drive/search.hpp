// What the two searches behind FastestRoutes have in common: one for robots of one speed, one for robots of many.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
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
  /// Finds the times to the goals, of all nodes, or with a start (its node in the direction of driving) of those that are
  /// not farther than it.
  virtual void fill(Size size, const WallSet& passages, const CellSet& goals, int start) = 0;
  static constexpr int everywhere = -1;
  /// The time until the end from a turn that begins at a node; one above the limit may be told as no_time.
  virtual DriveTime turning(int node, std::size_t lane, DriveTime limit) const = 0;
  virtual DriveTime rolling(int node, std::size_t lane) const = 0;
  virtual int node(HalfPoint point, int direction) const = 0;
  virtual HalfPoint point(int node) const = 0;
  virtual int direction(int node) const = 0;
  virtual bool passable(HalfPoint point) const = 0;
  /// How many nodes lie ahead before a wall; they have the next numbers.
  virtual int run(int node) const = 0;
  /// The turns that can begin at a node, as bits, and where one of them leads.
  virtual unsigned turns(int node) const = 0;
  virtual int leap(int node, unsigned bit) const = 0;
};

/// Nodes that wait, by time, in buckets as wide as a turn at most: those of one bucket do not depend on each other, so any
/// order will do (Denardo and Fox 1979; Dial 1969).
class Buckets {
 public:
  /// More than the longest straight or turn of any robot fills, so that they can be used in turn.
  static constexpr unsigned count = 256;

  /// For nodes with numbers below `nodes`. The lists do not lie a power of two apart, which caches dislike.
  Buckets(int nodes, int shift)
      : shift_(shift),
        stride_(static_cast<std::size_t>(nodes) + 72),
        waiting_(new std::uint16_t[count * stride_]),
        places_(static_cast<std::size_t>(nodes)) {
    clear();
  }

  void clear() {
    for (unsigned i = 0; i < count; ++i) ends_[i] = &waiting_[i * stride_];
    std::memset(places_.data(), 0xff, places_.size() * sizeof(places_[0]));
    last_ = 0;
  }
  unsigned bucket(DriveTime time) const { return static_cast<unsigned>(time >> shift_); }
  /// Lets a node wait until a time, once in each bucket, if that is earlier than another time. It is written down in any
  /// case, behind the last: a branch that nobody can foresee costs more.
  void add_if_earlier(DriveTime time, DriveTime known, int node) {
    const unsigned bucket = static_cast<unsigned>(time >> shift_);
    std::uint16_t& place = places_[static_cast<std::size_t>(node)];
    std::uint16_t*& end = ends_[bucket % count];
    const auto earlier = static_cast<unsigned>((time - known) >> 31);  // all ones or none
    const unsigned change = (place ^ bucket) & earlier & 0xffffU;
    place = static_cast<std::uint16_t>(place ^ change);
    *end = static_cast<std::uint16_t>(node);
    end += change != 0 ? 1 : 0;
    last_ = std::max(last_, bucket & earlier);
  }
  /// Calls visit(node) for all nodes of a bucket, and forgets them. None may be added to it meanwhile.
  template <class Visit>
  void empty(unsigned bucket, Visit visit) {
    std::uint16_t* const begin = &waiting_[bucket % count * stride_];
    const std::uint16_t* const end = ends_[bucket % count];
    for (const std::uint16_t* node = begin; node != end; ++node) visit(int{*node});
    ends_[bucket % count] = begin;
  }
  /// The last bucket that a node has been put into.
  unsigned last() const { return last_; }

 private:
  static constexpr std::uint16_t nowhere = 0xffff;

  int shift_;
  std::size_t stride_;
  unsigned last_ = 0;
  std::unique_ptr<std::uint16_t[]> waiting_;
  std::array<std::uint16_t*, count> ends_{};
  /// The bucket into which a node was put last; no time of a route is as late as the last one (see no_time).
  std::vector<std::uint16_t> places_;
};

/// The greatest power of two that is not above the shortest turn, as an exponent.
int bucket_shift(const DriveTables& tables);

std::unique_ptr<Search> make_fixed_search(Size size, const DriveTables& tables);
std::unique_ptr<Search> make_lane_search(Size size, const DriveTables& tables);

}  // namespace labmouse::drive
