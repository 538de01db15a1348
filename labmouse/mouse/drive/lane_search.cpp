// The search for robots of many speeds: a label for each lane in which a turn can end or begin at a node.
//
// Otherwise as in fixed_search.cpp, backwards from the goals. A label of a turn is spread along the corridor ahead into
// all lanes that a turn before it could have ended in, several at a time, and to the nodes where one could.
//
// In the open most straights are of no use beyond the next few nodes: whoever comes from farther away had better begin
// a turn there that is known already. Tables of how much later this one may be tell so exactly (LaneTables::slacks).
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
        onwards_(tables),
        backwards_(backwards(tables)),
        rolling_(static_cast<std::size_t>(L::nodes) * row, no_time),
        turning_(rolling_),
        waiting_(L::nodes, bucket_shift(tables)) {}

  void fill(const WallSet& passages, const CellSet& goals, int start) override {
    if (start != everywhere) aim_at(start);
    begin(passages);
    goals.for_each([&](Cell cell) {
      for (int direction = 0; direction < 8; direction += 2)
        begin_at(L::node({2 * cell.x + 1, 2 * cell.y + 1}, direction), onwards_);
    });
    const auto enough = [&] { return start == everywhere ? no_time : time_from(start); };
    finish(onwards_, start == everywhere ? no_bounds_ : bounds_, enough);
  }

  DriveTime turning(int node, std::size_t lane, DriveTime) const override {
    return time(turning_, L::opposite(node), lane);
  }
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
  static std::uint32_t label(int node, unsigned slot) { return static_cast<std::uint32_t>(node) * row + slot; }
  static unsigned kind_of(int node) {
    const unsigned diagonal = static_cast<unsigned>(node / L::plane) & 1U;
    return diagonal_node * diagonal | (centre_node & static_cast<unsigned>(node) & ~diagonal);
  }
  DriveTime time(const std::vector<DriveTime>& times, int node, std::size_t lane) const {
    const int slot = onwards_.slot(kind_of(node), lane);
    return slot == LaneTables::no_slot ? no_time : times[label(node, static_cast<unsigned>(slot))];
  }

  /// The time from rest at a start, as far as it is known; no_time where it is not, or where no turn is needed.
  DriveTime time_from(int start) const {
    Times best = Times{} + no_time;
    for (Word places = places_of_turns(start, lattice_.run(start)); places != 0; places &= places - 1) {
      const int units = std::countr_zero(places);
      const DriveTime* first = backwards_.finish() + static_cast<unsigned>(units) * row;
      const DriveTime* rest = &turning_[label(L::opposite(start + units), 0)];
      for (unsigned slot = 0; slot < row; slot += width) {
        const Times time = load(first + slot) + load(rest + slot);
        best = time < best ? time : best;
      }
    }
    return std::min(std::min(best[0], best[1]), std::min(best[2], best[3]));
  }
  /// The nodes ahead of this one, up to so many units away, where a turn can begin.
  Word places_of_turns(int node, int units) const {
    const unsigned beyond = static_cast<unsigned>(L::points - 1 - units) % L::points;
    return (lattice_.any_turn(node) >> node % L::points) & static_cast<Word>(~Word{0}) >> beyond;
  }

  /// Finds the bounds of a start: its times in the maze without inner walls, driven backwards.
  void aim_at(int start) {
    if (start == start_) return;
    start_ = start;
    begin(WallSet::all(size_));
    begin_at(start, backwards_);
    finish(backwards_, no_bounds_, [] { return no_time; });
    for (int node = 0; node < L::nodes; ++node) {
      if (node % L::points == 0) continue;  // no point
      const DriveTime* times = &rolling_[label(L::opposite(node), 0)];
      bounds_[index(node)] = *std::min_element(times, times + row);
    }
  }

  void begin(const WallSet& passages) {
    lattice_.build(size_, passages);
    forget_times();
    waiting_.clear();
  }

  void begin_at(int node, const LaneTables& lanes) { spread(node, 0, lanes.finish(), lattice_.run(node)); }

  /// Forgets the times of all nodes that a search has touched.
  void forget_times() {
    for (std::size_t word = 0; word < touched_.size(); ++word)
      for (std::uint64_t nodes = std::exchange(touched_[word], 0); nodes != 0; nodes &= nodes - 1) {
        const int node = static_cast<int>(64 * word) + std::countr_zero(nodes);
        for (unsigned slot = 0; slot < row; slot += width) {
          store(&rolling_[label(node, slot)], Times{} + no_time);
          store(&turning_[label(node, slot)], Times{} + no_time);
        }
        turns_due_[index(node)] = 0;
      }
  }
  void touch(int node) { touched_[index(node) / 64] |= std::uint64_t{1} << node % 64; }

  /// Goes on from the nodes to which straights have led, until no node waits for a time before enough().
  template <class Enough>
  void finish(const LaneTables& lanes, const std::vector<DriveTime>& bounds, Enough enough) {
    for (;;) {
      drive_turns(lanes);
      await(bounds);
      if (!waiting_.advance(enough())) return;
      drive_straights(lanes);
    }
  }

  /// Turns begin at the nodes whose time has come: spreads those in all slots that have improved.
  void drive_straights(const LaneTables& lanes) {
    ready_.clear();
    waiting_.empty([&](int node) { ready_.add_ones(label(node, 0), std::exchange(turns_due_[index(node)], 0)); });
    for (const std::uint32_t ready : ready_) {
      const int node = static_cast<int>(ready / row);
      const unsigned kind = kind_of(node), slot = ready % row;
      const int units = useful_units(node, turning_[ready], lanes.slacks(kind, slot), lanes.reach());
      spread(node, turning_[ready], lanes.straights(kind, slot), units);
    }
  }

  /// How long a straight to a turn at most is of use: behind another turn that would do for all mice from farther away,
  /// only as far as they are too near for that one.
  int useful_units(int node, DriveTime time, const DriveTime* slacks, int reach) const {
    int useful = lattice_.run(node);
    useful = std::min(useful, would_do(node, time, slacks) ? reach - 1 : useful);
    for (int units = 2; units + reach <= useful; units *= 2) {
      slacks += row;
      if (would_do(node + units, time, slacks)) return units + reach - 1;
    }
    return useful;
  }
  /// Whether a turn that begins at a node in another slot would do as well.
  bool would_do(int node, DriveTime time, const DriveTime* slacks) const {
    Times ahead{};
    for (unsigned slot = 0; slot < row; slot += width)
      ahead |= load(&turning_[label(node, slot)]) <= load(slacks + slot) + time;
    return bits_of(ahead) != 0;
  }

  /// A turn begins here, this time before the end: spreads it over the straights that lead to it, rows of times by
  /// units.
  void spread(int node, DriveTime time, const DriveTime* straights, int units) {
    for (Word places = places_of_turns(node, units); places != 0; places &= places - 1) {
      const auto unit = static_cast<unsigned>(std::countr_zero(places));
      const int there = node + static_cast<int>(unit);
      DriveTime* rolling = &rolling_[label(there, 0)];
      unsigned improved = 0;
      for (unsigned slot = 0; slot < row; slot += width) {
        const Times old = load(rolling + slot), now = load(straights + unit * row + slot) + time;
        const Times better = now < old;
        store(rolling + slot, (now & better) | (old & ~better));
        improved |= bits_of(better) << slot;
      }
      std::uint8_t& due = straights_due_[index(there)];
      driven_.add(static_cast<std::uint16_t>(there),
                  static_cast<unsigned>(due == 0) & static_cast<unsigned>(improved != 0));
      due = static_cast<std::uint8_t>(due | improved);
    }
  }

  /// Turns at all nodes to which straights have led, in those slots that have improved.
  void drive_turns(const LaneTables& lanes) {
    list_turns(lanes);
    improved_.clear();
    for (const std::uint32_t listed : turns_) {
      const int node = static_cast<int>(listed / LaneTables::most_turns);
      const TurnBefore& turn = lanes.turn(kind_of(node), listed % LaneTables::most_turns);
      const std::uint32_t to = label(leaps_[8 * index(node) + turn.bit], turn.before);
      const DriveTime known = turning_[to],
                      gain = std::min<DriveTime>(rolling_[label(node, turn.slot)] + turn.time - known, 0);
      turning_[to] = known + gain;
      improved_.add(to, static_cast<unsigned>(gain) >> 31);
    }
  }
  void list_turns(const LaneTables& lanes) {
    turns_.clear();
    for (const int node : driven_) {
      const unsigned slots = std::exchange(straights_due_[index(node)], 0);
      unsigned turns = lanes.turns(kind_of(node), slots, turn_bits(lattice_, node));
      for (auto first = static_cast<std::uint32_t>(node) * LaneTables::most_turns; turns != 0; turns >>= 8, first += 8)
        turns_.add_ones(first, turns & 255U);
      touch(node);
    }
    driven_.clear();
  }
  /// Lets the labels that turns have improved wait for their time.
  void await(const std::vector<DriveTime>& bounds) {
    for (const std::uint32_t improved : improved_) {
      const int node = static_cast<int>(improved / row);
      std::uint8_t& due = turns_due_[index(node)];
      due = static_cast<std::uint8_t>(due | 1U << improved % row);
      waiting_.add(node, turning_[improved] + bounds[index(node)]);
      touch(node);
    }
  }

  Size size_;
  const LaneTables onwards_, backwards_;
  L lattice_;
  const std::vector<std::uint16_t> leaps_ = L::leaps();
  std::vector<DriveTime> rolling_;  ///< by label: node, turned round, and slot
  std::vector<DriveTime> turning_;
  /// From the start to a node, turned round, at least.
  std::vector<DriveTime> bounds_ = std::vector<DriveTime>(static_cast<std::size_t>(L::nodes), 0);
  const std::vector<DriveTime> no_bounds_ = bounds_;
  int start_ = everywhere;
  Buckets waiting_;                       ///< nodes to which turns have led
  List<std::uint16_t> driven_{L::nodes};  ///< nodes to which straights have led
  /// By node, as bits: slots in which turns have led there, and straights.
  std::vector<std::uint8_t> turns_due_ = std::vector<std::uint8_t>(L::nodes);
  std::vector<std::uint8_t> straights_due_ = turns_due_;
  List<std::uint32_t> ready_{L::nodes * static_cast<int>(row)};  ///< labels of turns that are to be spread
  List<std::uint32_t> turns_{L::nodes * static_cast<int>(LaneTables::most_turns)};     ///< by node and number
  List<std::uint32_t> improved_{L::nodes * static_cast<int>(LaneTables::most_turns)};  ///< labels of turns
  /// Nodes of which times are known, as bits.
  std::vector<std::uint64_t> touched_ = std::vector<std::uint64_t>(L::nodes / 64);
};

}  // namespace

std::unique_ptr<Search> make_lane_search(Size size, const DriveTables& tables) {
  if (size.width <= 16 && size.height <= 16) return std::make_unique<LaneSearch<std::uint32_t>>(size, tables);
  return std::make_unique<LaneSearch<std::uint64_t>>(size, tables);
}

}  // namespace labmouse::drive
