// The search for robots of many speeds: a label for each lane in which a turn can end or begin at a node.
//
// Otherwise as in fixed_search.cpp, backwards from the goals. A label of a turn is spread along the corridor ahead into all
// lanes that a turn before it could have ended in, several at a time, and to the nodes where one could.
#include <algorithm>

#include "labmouse/mouse/drive/lane_tables.hpp"
#include "labmouse/mouse/drive/lists.hpp"
#include "labmouse/mouse/drive/search.hpp"
#include "labmouse/mouse/drive/vectors.hpp"

namespace labmouse::drive {
namespace {

template <class Word>
class LaneSearch final : public Search {
 public:
  using L = Lattice<Word>;

  LaneSearch(Size size, const DriveTables& tables)
      : size_(size),
        tables_(tables),
        onwards_(tables),
        backwards_(backwards(tables)),
        row_(onwards_.row()),
        rolling_(static_cast<std::size_t>(L::nodes * row_), no_time),
        turning_(rolling_),
        waiting_(L::nodes, bucket_shift(tables)) {}

  void fill(const WallSet& passages, const CellSet& goals, int start) override {
    if (start != everywhere) aim_at(start);
    begin(passages);
    goals.for_each([&](Cell cell) {
      for (int direction = 0; direction < 8; direction += 2)
        spread(L::node({2 * cell.x + 1, 2 * cell.y + 1}, direction), 0, onwards_.finish());
    });
    const auto enough = [&] { return start == everywhere ? no_time : time_from(start); };
    finish(onwards_, start == everywhere ? no_bounds_ : bounds_, enough);
  }

  DriveTime turning(int node, std::size_t lane, DriveTime) const override { return time(turning_, L::opposite(node), lane); }
  DriveTime rolling(int node, std::size_t lane) const override { return time(rolling_, L::opposite(node), lane); }
  int node(HalfPoint point, int direction) const override { return L::node(point, direction); }
  HalfPoint point(int node) const override { return L::point(node); }
  int direction(int node) const override { return L::direction(node); }
  bool passable(HalfPoint point) const override { return lattice_.passable(point); }
  int run(int node) const override { return lattice_.run(node); }
  unsigned turns(int node) const override { return turn_bits(lattice_, node); }
  int leap(int node, unsigned bit) const override { return leaps_[8 * index(node) + bit]; }

 private:
  static std::size_t index(int node) { return static_cast<std::size_t>(node); }
  std::size_t row(int node) const { return index(node * row_); }
  static unsigned kind_of(int node) {
    return node / L::plane % 2 != 0 ? diagonal_node : node % 2 == 0 ? edge_node : centre_node;
  }
  DriveTime time(const std::vector<DriveTime>& times, int node, std::size_t lane) const {
    const int slot = onwards_.slot(kind_of(node), lane);
    return slot == LaneTables::no_slot ? no_time : times[row(node) + index(slot)];
  }

  /// The time from rest at a start, as far as it is known; no_time where it is not, or where no turn is needed.
  DriveTime time_from(int start) const {
    DriveTime best = no_time;
    for (int units = 0, run = lattice_.run(start); units <= run; ++units)
      for (std::size_t lane = 0; lane < tables_.along.count(); ++lane)
        best = std::min(best, tables_.start_to(units, lane) + turning(start + units, lane, no_time));
    return best;
  }

  /// Finds the bounds of a start: its times in the maze without inner walls, driven backwards.
  void aim_at(int start) {
    if (start == start_) return;
    start_ = start;
    begin(WallSet::all(size_));
    spread(start, 0, backwards_.finish());
    finish(backwards_, no_bounds_, [] { return no_time; });
    for (int node = 0; node < L::nodes; ++node) {
      if (node % L::points == 0) continue;  // no point
      const DriveTime* times = &rolling_[row(L::opposite(node))];
      bounds_[index(node)] = *std::min_element(times, times + row_);
    }
  }

  void begin(const WallSet& passages) {
    lattice_.build(size_, passages);
    forget(rolling_);
    forget(turning_);
    std::fill(turns_due_.begin(), turns_due_.end(), 0);
    waiting_.clear();
  }

  template <class Enough>
  void finish(const LaneTables& lanes, const std::vector<DriveTime>& bounds, Enough enough) {
    do {
      drive_turns(lanes, bounds);
      if (!waiting_.advance(enough())) return;
      waiting_.empty([&](int node) { drive_straights(lanes, node, bounds[index(node)]); });
    } while (true);
  }

  /// Turns begin at this node: spreads those in slots whose time has come.
  void drive_straights(const LaneTables& lanes, int node, DriveTime bound) {
    const unsigned kind = kind_of(node);
    unsigned due = std::exchange(turns_due_[index(node)], 0);
    for (; due != 0; due &= due - 1) {
      const auto slot = static_cast<unsigned>(std::countr_zero(due));
      const DriveTime time = turning_[row(node) + slot];
      if (!waiting_.is_now(time + bound)) {
        turns_due_[index(node)] |= 1U << slot;
        waiting_.add(node, time + bound);
        continue;
      }
      const int units = useful_units(node, time, lanes.slacks(kind, slot), lanes.reach());
      spread(node, time, lanes.straights(kind, slot), units);
    }
  }

  /// How long a straight to a turn at most is of use: behind another turn that would do for all mice from farther away, only
  /// so many units more.
  int useful_units(int node, DriveTime time, const DriveTime* slacks, int reach) const {
    const int run = lattice_.run(node);
    for (int check = 0; check < LaneTables::checks; ++check, slacks += row_) {
      const int units = check == 0 ? 0 : 1 << check;
      if (units + reach >= run) break;
      const DriveTime* others = &turning_[row(node + units)];
      Times ahead{};
      for (int slot = 0; slot < row_; slot += width) ahead |= load(others + slot) <= load(slacks + slot) + time;
      if (bits_of(ahead) != 0) return units + reach;
    }
    return run;
  }

  void spread(int node, DriveTime time, const DriveTime* straights) { spread(node, time, straights, lattice_.run(node)); }

  /// A turn begins here, this time before the end: spreads it over the straights that lead to it, rows of times by units.
  void spread(int node, DriveTime time, const DriveTime* straights, int units) {
    Word places = (lattice_.any_turn(node) >> node % L::points) & static_cast<Word>(~Word{0}) >> (L::points - 1 - units);
    for (; places != 0; places &= places - 1) {
      const int unit = std::countr_zero(places), there = node + unit;
      DriveTime* rolling = &rolling_[row(there)];
      unsigned improved = 0;
      for (int slot = 0; slot < row_; slot += width) {
        const Times old = load(rolling + slot), now = load(straights + unit * row_ + slot) + time;
        const Times better = now < old;
        store(rolling + slot, (now & better) | (old & ~better));
        improved |= bits_of(better) << slot;
      }
      unsigned& due = straights_due_[index(there)];
      driven_.add(static_cast<std::uint16_t>(there), static_cast<unsigned>(due == 0) & static_cast<unsigned>(improved != 0));
      due |= improved;
    }
  }

  /// At all nodes to which straights have led, turns in those slots that have improved.
  void drive_turns(const LaneTables& lanes, const std::vector<DriveTime>& bounds) {
    for (const int node : driven_) {
      const unsigned kind = kind_of(node), bits = turn_bits(lattice_, node);
      unsigned due = std::exchange(straights_due_[index(node)], 0);
      for (; due != 0; due &= due - 1) {
        const auto slot = static_cast<unsigned>(std::countr_zero(due));
        for (const TurnBefore& turn : lanes.turns(kind, slot))
          if ((bits >> turn.bit & 1U) != 0)
            reach(leap(node, turn.bit), turn.slot, rolling_[row(node) + slot] + turn.time, bounds);
      }
    }
    driven_.clear();
  }

  void reach(int node, unsigned slot, DriveTime time, const std::vector<DriveTime>& bounds) {
    DriveTime& known = turning_[row(node) + slot];
    if (time >= known) return;
    known = time;
    turns_due_[index(node)] |= 1U << slot;
    waiting_.add(node, time + bounds[index(node)]);
  }

  Size size_;
  const DriveTables& tables_;
  const LaneTables onwards_, backwards_;
  int row_;
  L lattice_;
  std::span<const std::uint16_t> leaps_ = L::leaps();
  std::vector<DriveTime> rolling_;
  std::vector<DriveTime> turning_;
  std::vector<DriveTime> bounds_ = std::vector<DriveTime>(static_cast<std::size_t>(L::nodes), 0);
  const std::vector<DriveTime> no_bounds_ = bounds_;
  int start_ = everywhere;
  NodeSets waiting_;                                       ///< nodes to which turns have led
  std::vector<unsigned> turns_due_ = std::vector<unsigned>(L::nodes);      ///< their slots
  List<std::uint16_t> driven_{L::nodes};                   ///< nodes to which straights have led
  std::vector<unsigned> straights_due_ = std::vector<unsigned>(L::nodes);  ///< their slots
};

}  // namespace

std::unique_ptr<Search> make_lane_search(Size size, const DriveTables& tables) {
  if (size.width <= 16 && size.height <= 16) return std::make_unique<LaneSearch<std::uint32_t>>(size, tables);
  return std::make_unique<LaneSearch<std::uint64_t>>(size, tables);
}

}  // namespace labmouse::drive
