// The interface of the searches behind FastestRoutes: for robots with one speed, with one speed per turn, and with
// many.
#pragma once

#include <cstddef>
#include <memory>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/drive/lattice.hpp"
#include "labmouse/mouse/drive/memory_part.hpp"
#include "labmouse/mouse/robot/tables.hpp"

namespace labmouse::drive {

/// A search over the lattice. A label is a time to the goals: of a turn that begins at a node in a lane, or of a
/// straight that begins there after a turn that ended in a lane. Directions are those of driving.
class Search {
 public:
  virtual ~Search() = default;
  /// Finds the times to the goals: of all nodes, or with a start of those on fastest routes from there; other times may
  /// then be too late. `start` is a node in the direction of driving, or `everywhere`.
  /// Times above `limit` may be too late, with or without a start.
  virtual void fill(const WallSet& passages, const CellSet& goals, int start, DriveTime limit) = 0;
  /// Prepares fills with this start whose passages are all among these: they get closer bounds, and are faster.
  /// All nodes later than `latest` from the start have that time as their bound.
  virtual void aim(const WallSet& /*passages*/, int /*start*/, DriveTime /*latest*/) {}
  static constexpr int everywhere = -1;
  /// The time to the goals from a turn that begins at a node; one above the limit may be reported as no_time.
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

/// The width of a search's buckets, as an exponent of two: about the time of a turn, so that few labels improve after
/// they were spread.
int bucket_shift(const DriveTables& tables);

/// Destroys a search without freeing its memory, which the caller owns.
struct EndInPlace {
  void operator()(Search* search) const { search->~Search(); }
};
using SearchInPlace = std::unique_ptr<Search, EndInPlace>;

inline constexpr std::size_t search_alignment = 16;
constexpr std::size_t aligned(std::size_t bytes) {
  return (bytes + search_alignment - 1) / search_alignment * search_alignment;
}

/// The memory of a search, both parts aligned: what it keeps, and behind that scratch memory, which is free once a
/// field has been read.
struct SearchBytes {
  std::size_t kept = 0;
  std::size_t scratch = 0;
};

/// Makes the searches for one robot, and owns the tables that they share. Its arguments must outlive it.
class SearchMaker {
 public:
  virtual ~SearchMaker() = default;
  /// The memory for a search of a maze. make() needs it at a multiple of search_alignment.
  virtual SearchBytes bytes(Size size) const = 0;
  /// The parts of these bytes, without `other`.
  virtual MemoryLayout layout(Size size) const = 0;
  /// Bytes of the tables that all searches share.
  virtual std::size_t table_bytes() const = 0;
  virtual SearchInPlace make(Size size, std::byte* memory) const = 0;
  /// From now on the bounds that a search computes for a start are kept for others, too.
  virtual void keep_bounds() {}
};

/// The simplest search that a robot allows: fixed for one speed at all nodes, lead for one speed a turn, lane for many.
std::unique_ptr<SearchMaker> make_searches(const DriveTables& tables, const Leaps& leaps);
std::unique_ptr<SearchMaker> make_fixed_searches(const DriveTables& tables, const Leaps& leaps);
std::unique_ptr<SearchMaker> make_lead_searches(const DriveTables& tables, const Leaps& leaps);
std::unique_ptr<SearchMaker> make_lane_searches(const DriveTables& tables, const Leaps& leaps);

}  // namespace labmouse::drive
