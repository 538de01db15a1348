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
        rolling_(static_cast<std::size_t>(L::nodes * row), no_time),
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
  static std::size_t row_of(int node) { return index(row * node); }
  static unsigned kind_of(int node) {
    const unsigned diagonal = static_cast<unsigned>(node / L::plane) & 1U;
    return diagonal_node * diagonal | (centre_node & static_cast<unsigned>(node) & ~diagonal);
  }
  DriveTime time(const std::vector<DriveTime>& times, int node, std::size_t lane) const {
    const int slot = onwards_.slot(kind_of(node), lane);
    return slot == LaneTables::no_slot ? no_time : times[row_of(node) + index(slot)];
  }

  /// The time from rest at a start, as far as it is known; no_time where it is not, or where no turn is needed.
  DriveTime time_from(int start) const {
    Times best = Times{} + no_time;
    for (Word places = places_of_turns(start, lattice_.run(start)); places != 0; places &= places - 1) {
      const int units = std::countr_zero(places);
      const DriveTime* first = backwards_.finish() + units * row;
      const DriveTime* rest = &turning_[row_of(L::opposite(start + units))];
      for (int slot = 0; slot < row; slot += width) {
        const Times time = load(first + slot) + load(rest + slot);
        best = time < best ? time : best;
      }
    }
    return std::min(std::min(best[0], best[1]), std::min(best[2], best[3]));
  }
  /// The nodes ahead of this one, up to so many units away, where a turn can begin.
  Word places_of_turns(int node, int units) const {
    return (lattice_.any_turn(node) >> node % L::points) & static_cast<Word>(~Word{0}) >> (L::points - 1 - units);
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
      const DriveTime* times = &rolling_[row_of(L::opposite(node))];
      bounds_[index(node)] = *std::min_element(times, times + row);
    }
  }

  void begin(const WallSet& passages) {
    lattice_.build(size_, passages);
    forget_times();
    waiting_.clear();
  }

  /// Forgets the times of all nodes that a search has touched.
  void forget_times() {
    for (std::size_t word = 0; word < touched_.size(); ++word)
      for (std::uint64_t nodes = std::exchange(touched_[word], 0); nodes != 0; nodes &= nodes - 1) {
        const int node = static_cast<int>(64 * word) + std::countr_zero(nodes);
        for (int slot = 0; slot < row; slot += width) {
          store(&rolling_[row_of(node) + index(slot)], Times{} + no_time);
          store(&turning_[row_of(node) + index(slot)], Times{} + no_time);
        }
        turns_due_[index(node)] = 0;
      }
  }
  void touch(int node) { touched_[index(node) / 64] |= std::uint64_t{1} << node % 64; }

  template <class Enough>
  void finish(const LaneTables& lanes, const std::vector<DriveTime>& bounds, Enough enough) {
    do {
      drive_turns(lanes, bounds);
      if (!waiting_.advance(enough())) return;
      drive_straights(lanes);
    } while (true);
  }

  /// Turns begin at the nodes whose time has come: spreads those of all slots that have improved.
  void drive_straights(const LaneTables& lanes) {
    ready_.clear();
    waiting_.empty([&](int node) { ready_.add_ones(static_cast<std::uint32_t>(8 * node), std::exchange(turns_due_[index(node)], 0)); });
    for (const std::uint32_t label : ready_) {
      const int node = static_cast<int>(label / 8);
      const unsigned kind = kind_of(node), slot = label % 8;
      const DriveTime time = turning_[row_of(node) + slot];
      const int units = useful_units(node, time, lanes.slacks(kind, slot), lanes.reach());
      spread(node, time, lanes.straights(kind, slot), units);
    }
  }

  /// How long a straight to a turn at most is of use: behind another turn that would do for all mice from farther away, only
  /// so many units more.
  int useful_units(int node, DriveTime time, const DriveTime* slacks, int reach) const {
    int useful = lattice_.run(node);
    useful = std::min(useful, would_do(node, time, slacks) ? reach : useful);
    for (int units = 2; units + reach < useful; units *= 2) {
      slacks += row;
      if (would_do(node + units, time, slacks)) return units + reach;
    }
    return useful;
  }
  /// Whether a turn that begins at a node in another slot would do as well.
  bool would_do(int node, DriveTime time, const DriveTime* slacks) const {
    Times ahead{};
    for (std::size_t slot = 0; slot < row; slot += width)
      ahead |= load(&turning_[row_of(node) + slot]) <= load(slacks + slot) + time;
    return bits_of(ahead) != 0;
  }

  void spread(int node, DriveTime time, const DriveTime* straights) { spread(node, time, straights, lattice_.run(node)); }

  /// A turn begins here, this time before the end: spreads it over the straights that lead to it, rows of times by units.
  void spread(int node, DriveTime time, const DriveTime* straights, int units) {
    for (Word places = places_of_turns(node, units); places != 0; places &= places - 1) {
      const int unit = std::countr_zero(places), there = node + unit;
      DriveTime* rolling = &rolling_[row_of(there)];
      unsigned improved = 0;
      for (int slot = 0; slot < row; slot += width) {
        const Times old = load(rolling + slot), now = load(straights + unit * row + slot) + time;
        const Times better = now < old;
        store(rolling + slot, (now & better) | (old & ~better));
        improved |= bits_of(better) << slot;
      }
      std::uint8_t& due = straights_due_[index(there)];
      driven_.add(static_cast<std::uint16_t>(there), static_cast<unsigned>(due == 0) & static_cast<unsigned>(improved != 0));
      due = static_cast<std::uint8_t>(due | improved);
    }
  }

  /// At all nodes to which straights have led, turns in those slots that have improved.
  void drive_turns(const LaneTables& lanes, const std::vector<DriveTime>& bounds) {
    turns_.clear();
    for (const int node : driven_) {
      touch(node);
      unsigned turns = lanes.turns(kind_of(node), std::exchange(straights_due_[index(node)], 0), turn_bits(lattice_, node));
      for (int first = 0; turns != 0; first += 8, turns >>= 8) turns_.add_ones(static_cast<std::uint32_t>(32 * node + first), turns & 255U);
    }
    driven_.clear();
    improved_.clear();
    for (const std::uint32_t turn : turns_) {
      const int node = static_cast<int>(turn / 32);
      const TurnBefore& before = lanes.turn(kind_of(node), turn % 32);
      const int to = leaps_[8 * index(node) + before.bit];
      DriveTime& known = turning_[row_of(to) + before.before];
      const DriveTime gain = std::min(rolling_[row_of(node) + before.slot] + before.time - known, 0);
      known += gain;
      improved_.add(static_cast<std::uint32_t>(8 * to + before.before), static_cast<unsigned>(gain) >> 31);
    }
    for (const std::uint32_t label : improved_) {
      const int node = static_cast<int>(label / 8);
      touch(node);
      turns_due_[index(node)] = static_cast<std::uint8_t>(turns_due_[index(node)] | 1U << label % 8);
      waiting_.add(node, turning_[row_of(node) + label % 8] + bounds[index(node)]);
    }
  }

  Size size_;
  const DriveTables& tables_;
  const LaneTables onwards_, backwards_;
  L lattice_;
  std::span<const std::uint16_t> leaps_ = L::leaps();
  std::vector<DriveTime> rolling_;
  std::vector<DriveTime> turning_;
  std::vector<DriveTime> bounds_ = std::vector<DriveTime>(static_cast<std::size_t>(L::nodes), 0);
  const std::vector<DriveTime> no_bounds_ = bounds_;
  int start_ = everywhere;
  NodeSets waiting_;                                                                 ///< nodes to which turns have led
  std::vector<std::uint8_t> turns_due_ = std::vector<std::uint8_t>(L::nodes);        ///< their slots
  List<std::uint32_t> ready_{8 * L::nodes};                                          ///< their labels
  List<std::uint16_t> driven_{L::nodes};                                             ///< nodes to which straights have led
  std::vector<std::uint8_t> straights_due_ = std::vector<std::uint8_t>(L::nodes);    ///< their slots
  List<std::uint32_t> turns_{32 * L::nodes};
  List<std::uint32_t> improved_{32 * L::nodes};
  std::vector<std::uint64_t> touched_ = std::vector<std::uint64_t>(L::nodes / 64);
};

}  // namespace

std::unique_ptr<Search> make_lane_search(Size size, const DriveTables& tables) {
  if (size.width <= 16 && size.height <= 16) return std::make_unique<LaneSearch<std::uint32_t>>(size, tables);
  return std::make_unique<LaneSearch<std::uint64_t>>(size, tables);
}

}  // namespace labmouse::drive
