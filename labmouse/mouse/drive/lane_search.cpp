// The search for robots of many speeds: a label for each lane in which a turn can end or begin at a node.
//
// Otherwise as in fixed_search.cpp, backwards from the goals. The label of a turn is spread along the corridor ahead,
// to all nodes and lanes in which a turn before it could have ended, several lanes at a time.
//
// In the open most straights are of no use beyond the next few nodes: from farther away, another known turn is better.
// LaneTables::slacks decides this exactly.
#include <algorithm>
#include <cassert>

#include "labmouse/mouse/drive/kept_bounds.hpp"
#include "labmouse/mouse/drive/lane_tables.hpp"
#include "labmouse/mouse/drive/lists.hpp"
#include "labmouse/mouse/drive/search.hpp"
#include "labmouse/mouse/drive/vectors.hpp"

namespace labmouse::drive {
namespace {

/// The tables of a robot as its searches use them.
struct BothWays {
  BothWays(const DriveTables& tables, unsigned speeds)
      : onwards(tables, speeds), backwards(drive::backwards(tables), speeds), shift(bucket_shift(tables)) {}

  LaneTables onwards, backwards;
  int shift;
};

/// For up to `Speeds` speeds of each turn. The labels of the nodes of a line lie one behind the other, by slots: the
/// whole vectors of a row overlap with labels of the nodes about it, which must not change.
template <class Word, unsigned Speeds>
class LaneSearch final : public Search {
 public:
  using L = Lattice<Word>;

  LaneSearch(Size size, const BothWays& lanes, const Leaps& leaps, KeptBounds<L::nodes>& kept)
      : lanes_(lanes), size_(size), leaps_(leaps.of<Word>()), kept_(kept), waiting_(lanes.shift) {
    forget(rolling_, labels);
    forget(turning_, labels);
  }

  void fill(const WallSet& passages, const CellSet& goals, int start, DriveTime limit) override {
    if (start != everywhere && !is_aimed_at(passages, start)) aim_at(start);
    begin(passages);
    enough_ = limit;
    goals.for_each([&](Cell cell) {
      for (int direction = 0; direction < 8; direction += 2) {
        const int node = L::node({2 * cell.x + 1, 2 * cell.y + 1}, direction);
        spread(node, 0, lanes_.onwards.finish(lattice_.run(L::opposite(node)) / 2), lattice_.run(node));
      }
    });
    if (start == everywhere)
      finish(lanes_.onwards, NoBounds(), [] { return no_time; });
    else
      finish(lanes_.onwards, bounds_, [&] { return std::min(limit, time_from(start)); });
  }
  void aim(const WallSet& passages, int start, DriveTime latest) override {
    find_bounds(passages, start, latest);
    note_aim(passages, start);
  }

  static MemoryLayout layout() {
    return {{"labels", sizeof(rolling_) + sizeof(turning_)},
            {"lattice", sizeof(L)},
            {"bounds", sizeof(bounds_)},
            {"waiting", sizeof(waiting_) + sizeof(driven_) + sizeof(turns_due_) + sizeof(straights_due_)}};
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
  /// Slots as bits.
  using Slots =
      std::conditional_t<(Speeds <= 2), std::uint8_t, std::conditional_t<(Speeds <= 4), std::uint16_t, std::uint32_t>>;
  /// A row of cells as bits.
  using Row = std::conditional_t<sizeof(Word) == sizeof(std::uint32_t), std::uint16_t, std::uint32_t>;
  static constexpr unsigned speeds = Speeds;
  static constexpr std::size_t labels = slots_a_speed * Speeds * static_cast<std::size_t>(L::nodes + 1) + width;
  /// Length of the lists.
  static constexpr int chunk = 96;

  static std::size_t index(int node) { return static_cast<std::size_t>(node); }
  static bool is_diagonal(int node) { return (static_cast<unsigned>(node / L::plane) & 1U) != 0; }
  static unsigned kind_of(int node) {
    return is_diagonal(node) ? diagonal_node : centre_node & static_cast<unsigned>(node);
  }
  /// The first label of a node.
  static std::size_t label(int node) { return slots_a_speed * Speeds * index(node); }
  static unsigned end_slot(int node) { return end_slot_a_speed[kind_of(node)] * Speeds; }
  /// A node and a slot, packed into one number.
  static std::uint32_t stand(int node, unsigned slot) { return static_cast<std::uint32_t>(node) * 32 + slot; }
  static int node_of(std::uint32_t stand) { return static_cast<int>(stand / 32); }
  static std::size_t label_of(std::uint32_t stand) { return label(node_of(stand)) + stand % 32; }

  DriveTime time(const DriveTime* times, int node, std::size_t lane) const {
    const int slot = lanes_.onwards.slot(kind_of(node), lane);
    return slot == LaneTables::no_slot ? no_time : times[label(node) + static_cast<unsigned>(slot)];
  }

  /// The time from rest at a start, as far as it is known; no_time where it is not, or where no turn is needed.
  DriveTime time_from(int start) const {
    constexpr unsigned row = row_of(centre_node, Speeds);
    const DriveTime* const first = lanes_.backwards.finish(0);
    Times best = Times{} + no_time;
    for (Word places = places_of_turns(start, lattice_.run(start)); places != 0; places &= places - 1) {
      const auto units = static_cast<unsigned>(std::countr_zero(places));
      const DriveTime* rest = &turning_[label(L::opposite(start + static_cast<int>(units)))];
      for (unsigned slot = 0; slot < row; slot += width) {
        const Times time = load(first + units * row + slot) + load(rest + slot);
        best = time < best ? time : best;
      }
    }
    return std::min(std::min(best[0], best[1]), std::min(best[2], best[3]));
  }
  /// The nodes ahead of this one, up to `units` away, where a turn can begin.
  Word places_of_turns(int node, int units) const {
    const unsigned beyond = static_cast<unsigned>(L::points - 1 - units) % L::points;
    return (lattice_.any_turn(node) >> node % L::points) & static_cast<Word>(~Word{0}) >> beyond;
  }

  /// Whether the bounds hold for a start and these passages.
  bool is_aimed_at(const WallSet& passages, int start) const {
    std::uint64_t others = 0;
    for (int y = 0; y < L::lines; ++y)
      others |= (passages.north().row(y) & ~std::uint64_t{aimed_north_[y]}) |
                (passages.east().row(y) & ~std::uint64_t{aimed_east_[y]});
    return start == start_ && others == 0;
  }
  void note_aim(const WallSet& passages, int start) {
    start_ = start;
    for (int y = 0; y < L::lines; ++y) {
      aimed_north_[y] = static_cast<Row>(passages.north().row(y));
      aimed_east_[y] = static_cast<Row>(passages.east().row(y));
    }
  }
  /// Takes the bounds of the maze without inner walls.
  void aim_at(int start) {
    const WallSet all = WallSet::all(size_);
    note_aim(all, start);
    if (const auto* known = kept_.find(size_, start)) {
      bounds_ = *known;
      return;
    }
    find_bounds(all, start, no_time);
    kept_.keep(size_, start, bounds_);
  }
  /// Finds the bounds of a start: its times over these passages, driven backwards, up to the latest that counts.
  void find_bounds(const WallSet& passages, int start, DriveTime latest) {
    begin(passages);
    spread(start, 0, lanes_.backwards.finish(0), lattice_.run(start));
    finish(lanes_.backwards, NoBounds(), [&] { return latest; });
    bounds_.set([&](int node) {
      if (node % L::points == 0) return no_time;  // no point
      const DriveTime* times = &rolling_[label(L::opposite(node))];
      const DriveTime time =
          *std::min_element(times + first_slot_a_speed[kind_of(node)] * Speeds, times + end_slot(node));
      // A search that was cut short leaves later times that are too late.
      return latest < no_time ? std::min(time, latest) : time;
    });
  }

  void begin(const WallSet& passages) {
    lattice_.build(size_, passages);
    forget_times();
    waiting_.clear();
    enough_ = no_time;
  }

  /// Resets the times of all nodes that a search has touched.
  void forget_times() {
    for (std::size_t word = 0; word < std::size(touched_); ++word)
      for (std::uint64_t nodes = std::exchange(touched_[word], 0); nodes != 0; nodes &= nodes - 1) {
        const int node = static_cast<int>(64 * word) + std::countr_zero(nodes);
        for (unsigned slot = 0; slot < end_slot(node); slot += width) {
          store(&rolling_[label(node) + slot], Times{} + no_time);
          store(&turning_[label(node) + slot], Times{} + no_time);
        }
        turns_due_[index(node)] = 0;
      }
  }
  void touch(int node) { touched_[index(node) / 64] |= std::uint64_t{1} << node % 64; }

  /// Goes on from the nodes to which straights have led, until no node is queued for a time before enough().
  template <class Bounds, class Enough>
  void finish(const LaneTables& lanes, const Bounds& bounds, Enough enough) {
    for (;;) {
      drive_turns(lanes, bounds);
      enough_ = enough();
      if (!waiting_.advance(enough_)) return;
      drive_straights(lanes);
    }
  }

  /// Turns begin at the nodes whose time has come: spreads their improved slots.
  void drive_straights(const LaneTables& lanes) {
    ready_.clear();
    waiting_.empty([&](int node) {
      Slots slots = std::exchange(turns_due_[index(node)], Slots{0});
      for (unsigned first = 0; first < 8 * sizeof(Slots); first += 8)
        ready_.add_ones(stand(node, first), static_cast<unsigned>(slots >> first) & 255U);
      if (!ready_.takes(8 * sizeof(Slots))) drive_ready_straights(lanes);
    });
    drive_ready_straights(lanes);
  }
  void drive_ready_straights(const LaneTables& lanes) {
    for (const std::uint32_t ready : ready_) {
      const int node = node_of(ready);
      const unsigned kind = kind_of(node), slot = ready % 32;
      const DriveTime time = turning_[label(node) + slot];
      const int units = useful_units(node, time, lanes.slacks(kind, slot), lanes.reach());
      spread(node, time, lanes.straights(kind, slot), units);
    }
    ready_.clear();
  }

  /// The length of a row of straights that lead to a node.
  static unsigned row(int node) { return row_of(is_diagonal(node) ? diagonal_node : centre_node, Speeds); }

  /// The greatest useful length of a straight to a turn. If another turn would do for all places farther away, only the
  /// places that are too near for that one are left.
  int useful_units(int node, DriveTime time, const DriveTime* slacks, int reach) const {
    const unsigned row = LaneSearch::row(node);
    int useful = lattice_.run(node);
    useful = std::min(useful, would_do(node, time, slacks, row) ? reach - 1 : useful);
    for (int units = 2; units + reach <= useful; units *= 2) {
      slacks += row;
      if (would_do(node + units, time, slacks, row)) return units + reach - 1;
    }
    return useful;
  }
  /// Whether a turn that begins at a node in another slot would do as well.
  bool would_do(int node, DriveTime time, const DriveTime* slacks, unsigned row) const {
    const DriveTime* const turning = &turning_[label(node)];
    Times ahead{};
    for (unsigned slot = 0; slot < row; slot += width) ahead |= load(turning + slot) <= load(slacks + slot) + time;
    return bits_of(ahead) != 0;
  }

  /// A turn begins here, `time` before the end: spreads it over the straights that lead to it, which are rows of times
  /// by units.
  void spread(int node, DriveTime time, const DriveTime* straights, int units) {
    constexpr unsigned along = row_of(centre_node, Speeds), across = row_of(diagonal_node, Speeds);
    if constexpr (along != across)
      if (is_diagonal(node)) return spread_over<across>(node, time, straights, units);
    spread_over<along>(node, time, straights, units);
  }
  template <unsigned Row>
  void spread_over(int node, DriveTime time, const DriveTime* straights, int units) {
    for (Word places = places_of_turns(node, units); places != 0; places &= places - 1) {
      const auto unit = static_cast<unsigned>(std::countr_zero(places));
      const int there = node + static_cast<int>(unit);
      DriveTime* rolling = &rolling_[label(there)];
      Slots improved = 0;
      for (unsigned slot = 0; slot < Row; slot += width) {
        const Times old = load(rolling + slot), now = load(straights + unit * Row + slot) + time;
        const Times better = now < old;
        store(rolling + slot, (now & better) | (old & ~better));
        improved = static_cast<Slots>(improved | bits_of(better) << slot);
      }
      Slots& due = straights_due_[index(there)];
      driven_.add(static_cast<std::uint16_t>(there),
                  static_cast<unsigned>(due == 0) & static_cast<unsigned>(improved != 0));
      due = static_cast<Slots>(due | improved);
    }
  }

  /// Tries the turns at all nodes to which straights have led, in those slots that have improved.
  template <class Bounds>
  void drive_turns(const LaneTables& lanes, const Bounds& bounds) {
    turns_.clear();
    for (const int node : driven_) {
      const Slots slots = std::exchange(straights_due_[index(node)], Slots{0});
      std::uint64_t turns = lanes.turns(kind_of(node), slots, turn_bits(lattice_, node));
      for (auto first = static_cast<std::uint32_t>(node) * most_turns; turns != 0; turns >>= 8, first += 8)
        turns_.add_ones(first, static_cast<unsigned>(turns) & 255U);
      touch(node);
      if (!turns_.takes(most_turns)) drive_listed_turns(lanes, bounds);
    }
    driven_.clear();
    drive_listed_turns(lanes, bounds);
  }
  template <class Bounds>
  void drive_listed_turns(const LaneTables& lanes, const Bounds& bounds) {
    for (const std::uint32_t listed : turns_) {
      const int node = static_cast<int>(listed / most_turns);
      const TurnBefore* turn = lanes.turn(kind_of(node), listed % most_turns);
      const int before = leaps_[8 * index(node) + turn->bit];
      const DriveTime rest = rolling_[label(node) + turn->slot];
      drive(before, *turn, rest);
      if (!turn->more) continue;
      do drive(before, *++turn, rest);
      while (turn->more);
      if (!improved_.takes(chunk + most_of_one)) await(bounds);
    }
    turns_.clear();
    await(bounds);
  }
  void drive(int before, const TurnBefore& turn, DriveTime rest) {
    const std::uint32_t to = stand(before, turn.before);
    DriveTime& known = turning_[label_of(to)];
    const DriveTime gain = std::min<DriveTime>(rest + turn.time - known, 0);
    known += gain;
    improved_.add(to, static_cast<unsigned>(gain) >> 31);
  }
  /// Queues the labels that turns have improved, if they can be part of a route that is early enough.
  template <class Bounds>
  void await(const Bounds& bounds) {
    for (const std::uint32_t improved : improved_) {
      const int node = node_of(improved);
      touch(node);
      const DriveTime time = turning_[label_of(improved)] + bounds[node];
      if (time > enough_) continue;
      Slots& due = turns_due_[index(node)];
      due = static_cast<Slots>(due | Slots{1} << improved % 32);
      waiting_.add(node, time);
    }
    improved_.clear();
  }

  static constexpr unsigned most_turns = LaneTables::most_turns;
  /// The most turns that agree in their end slot and bit.
  static constexpr int most_of_one = 8;

  const BothWays& lanes_;
  Size size_;
  const std::uint16_t* leaps_;
  KeptBounds<L::nodes>& kept_;
  int start_ = everywhere;
  Row aimed_north_[L::lines]{}, aimed_east_[L::lines]{};  ///< passages for which the bounds hold
  DriveTime enough_ = no_time;                            ///< later labels are of no use
  L lattice_;
  DriveTime rolling_[labels];  ///< by label
  DriveTime turning_[labels];
  Bounds<L::nodes> bounds_;               ///< lower bounds of the times from the start to the reversed node
  Buckets<L::nodes, 8> waiting_;          ///< nodes to which turns have led
  List<std::uint16_t, L::nodes> driven_;  ///< nodes to which straights have led
  /// By node: the slots that turns have improved, and those that straights have.
  Slots turns_due_[L::nodes]{};
  Slots straights_due_[L::nodes]{};
  List<std::uint32_t, chunk> ready_;                         ///< turns that are to be spread
  List<std::uint32_t, chunk> turns_;                         ///< by node and number
  List<std::uint32_t, 2 * (chunk + most_of_one)> improved_;  ///< where turns begin
  /// Nodes of which times are known, as bits.
  std::uint64_t touched_[L::nodes / 64]{};
};

template <unsigned Speeds>
class LaneSearches final : public SearchMaker {
 public:
  LaneSearches(const DriveTables& tables, const Leaps& leaps) : lanes_(tables, Speeds), leaps_(leaps) {}

  SearchBytes bytes(Size size) const override {
    using Small = LaneSearch<std::uint32_t, Speeds>;
    using Large = LaneSearch<std::uint64_t, Speeds>;
    return {aligned(is_small(size) ? sizeof(Small) : sizeof(Large)), 0};
  }
  MemoryLayout layout(Size size) const override {
    return is_small(size) ? LaneSearch<std::uint32_t, Speeds>::layout() : LaneSearch<std::uint64_t, Speeds>::layout();
  }
  std::size_t table_bytes() const override { return lanes_.onwards.bytes() + lanes_.backwards.bytes(); }
  SearchInPlace make(Size size, std::byte* memory) const override {
    if (is_small(size))
      return SearchInPlace(new (memory) LaneSearch<std::uint32_t, Speeds>(size, lanes_, leaps_, small_));
    return SearchInPlace(new (memory) LaneSearch<std::uint64_t, Speeds>(size, lanes_, leaps_, large_));
  }
  void keep_bounds() override {
    small_.start_keeping();
    large_.start_keeping();
  }

 private:
  BothWays lanes_;
  const Leaps& leaps_;
  mutable KeptBounds<Lattice<std::uint32_t>::nodes> small_;
  mutable KeptBounds<Lattice<std::uint64_t>::nodes> large_;
};

}  // namespace

std::unique_ptr<SearchMaker> make_lane_searches(const DriveTables& tables, const Leaps& leaps) {
  switch (speeds_for(tables)) {
    case 2:
      return std::make_unique<LaneSearches<2>>(tables, leaps);
    case 4:
      return std::make_unique<LaneSearches<4>>(tables, leaps);
    case 6:
      return std::make_unique<LaneSearches<6>>(tables, leaps);
    default:
      assert(speeds_for(tables) == 8);
      return std::make_unique<LaneSearches<8>>(tables, leaps);
  }
}

}  // namespace labmouse::drive
