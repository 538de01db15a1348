// The search for robots that have one speed at all nodes: one lane along the axes and one on the diagonals.
//
// It goes from the goals backwards in time, which is forwards over reversed nodes: turns and their times are the same
// both ways. The label of a turn is spread along the corridor ahead, several nodes at once. Then turns are tried from
// all nodes that have improved, and the nodes that these improve are queued for their time.
//
// With a start it is A* (Hart, Nilsson and Raphael 1968): a node is queued for its time to the goals plus its time from
// the start in the maze without inner walls, which is a lower bound.
#include <algorithm>

#include "labmouse/mouse/drive/kept_bounds.hpp"
#include "labmouse/mouse/drive/lists.hpp"
#include "labmouse/mouse/drive/search.hpp"
#include "labmouse/mouse/drive/vectors.hpp"

namespace labmouse::drive {
namespace {

/// Number of nodes that are processed together.
constexpr int stretch = 2 * width;

/// Times by units. gain[k] is the least of t(k + j) - t(j): how much longer, at least and at any place further on, it
/// takes to drive on through k units than to start anew after them.
struct Straight {
  DriveTime times[StraightTimes::longest + 1 + stretch]{};
  DriveTime gain[StraightTimes::longest + 1]{};
};

Straight straight_of(const StraightTimes& table) {
  Straight straight;
  for (int units = 0; units <= StraightTimes::longest; ++units) straight.times[units] = table.at(units, 0, 0);
  for (int k = 0; k <= StraightTimes::longest; ++k) {
    straight.gain[k] = straight.times[k];
    for (int j = 1; k + j <= StraightTimes::longest; ++j)
      straight.gain[k] = std::min(straight.gain[k], straight.times[k + j] - straight.times[j]);
  }
  return straight;
}

/// The tables of a robot of one speed as its searches use them.
struct FixedTables {
  explicit FixedTables(const DriveTables& tables)
      : straights{straight_of(tables.along), straight_of(tables.diagonal)}, shift(bucket_shift(tables)) {
    for (const DrivenTurn& turn : tables.turns)
      for (unsigned bit = 0; bit < 8; ++bit) {
        if (turn.turn == turn_of(bit, false, true)) turn_times[0][bit] = turn.time;
        if (turn.turn == turn_of(bit, false, false)) turn_times[0][8 + bit] = turn.time;
        if (bit < 3 && turn.turn == turn_of(bit, true, false)) turn_times[1][bit] = turn_times[1][8 + bit] = turn.time;
      }
  }

  Straight straights[2];
  /// By kind of line, parity of the position and bit.
  DriveTime turn_times[2][16]{};
  int shift;
};

template <class Word>
class FixedSearch final : public Search {
 public:
  using L = Lattice<Word>;

  static constexpr std::size_t labels = L::nodes + stretch;

  FixedSearch(Size size, const FixedTables& tables, const Leaps& leaps, KeptBounds<L::nodes>& kept, DriveTime* times)
      : tables_(tables), size_(size), leaps_(leaps.of<Word>()), kept_(kept), times_(times), waiting_(tables.shift) {}

  void fill(const WallSet& passages, const CellSet& goals, int start, DriveTime /*limit*/) override {
    if (start != everywhere) aim_at(start);
    begin(passages);
    goals.for_each([&](Cell cell) {
      for (int direction = 0; direction < 8; direction += 2)
        spread(L::node({2 * cell.x + 1, 2 * cell.y + 1}, direction), 0);
    });
    if (start == everywhere)
      finish(no_time, NoBounds());
    else
      finish(times_[L::opposite(start)], bounds_);
  }

  static MemoryLayout layout() {
    return {{"labels", sizeof(DriveTime) * labels},
            {"lattice", sizeof(L)},
            {"bounds", sizeof(bounds_)},
            {"waiting", sizeof(waiting_) + sizeof(driven_)}};
  }

  DriveTime turning(int node, std::size_t, DriveTime limit) const override {
    if (rolling(node, 0) > limit) return no_time;
    DriveTime best = no_time;
    for (unsigned bits = turns(node); bits != 0; bits &= bits - 1) {
      const auto bit = static_cast<unsigned>(std::countr_zero(bits));
      best = std::min(best, turn_time(8 * static_cast<unsigned>(node) + bit) + rolling(leap(node, bit), 0));
    }
    return best;
  }
  DriveTime rolling(int node, std::size_t) const override { return times_[index(L::opposite(node))]; }
  int node(HalfPoint point, int direction) const override { return L::node(point, direction); }
  HalfPoint point(int node) const override { return L::point(node); }
  int direction(int node) const override { return L::direction(node); }
  bool passable(HalfPoint point) const override { return lattice_.passable(point); }
  int run(int node) const override { return lattice_.run(node); }
  unsigned turns(int node) const override { return turn_bits(lattice_, node); }
  int leap(int node, unsigned bit) const override { return leaps_[8 * index(node) + bit]; }

 private:
  /// From [stretch - n] on: n lanes of ones, and zeros.
  static constexpr DriveTime first_lanes[2 * stretch] = {-1, -1, -1, -1, -1, -1, -1, -1};

  /// A node and the bit of a turn that begins there: 8 * node + bit. Turns of one kind share their last four bits.
  using TurnAt = std::conditional_t<sizeof(Word) == sizeof(std::uint32_t), std::uint16_t, std::uint32_t>;

  static std::size_t index(int node) { return static_cast<std::size_t>(node); }

  DriveTime turn_time(unsigned turn) const { return tables_.turn_times[turn / (8 * L::plane) % 2][turn % 16]; }

  /// Finds the bounds of a start: its times in the maze without inner walls, driven backwards.
  void aim_at(int start) {
    if (start == start_) return;
    start_ = start;
    if (const auto* known = kept_.find(size_, start)) {
      bounds_ = *known;
      return;
    }
    begin(WallSet::all(size_));
    spread(start, 0);
    finish(no_time, NoBounds());
    bounds_.set([&](int node) { return node % L::points == 0 ? no_time : times_[L::opposite(node)]; });
    kept_.keep(size_, start, bounds_);
  }

  void begin(const WallSet& passages) {
    lattice_.build(size_, passages);
    forget(times_, labels);
    waiting_.clear();
  }

  /// Goes on from the nodes that have been spread, until no node is queued for a time before `enough`.
  template <class Bounds>
  void finish(const DriveTime& enough, const Bounds& bounds) {
    const auto time_of = [&](int node) { return times_[index(node)] + bounds[node]; };
    for (;;) {
      drive_turns(bounds);
      if (!waiting_.advance(enough)) return;
      waiting_.empty([&](int node) {
        if (!waiting_.passed(time_of(node) + bounds.error())) spread(node, times_[index(node)]);
      });
    }
  }

  /// A turn leads to this node: spreads the times of straights of all lengths from here, a stretch at a time, since few
  /// are longer. Turns will be tried from all nodes that this improves, and from the node itself.
  void spread(int node, DriveTime time) {
    const Straight& straight = tables_.straights[static_cast<unsigned>(node / L::plane) & 1U];
    const int run = lattice_.run(node);
    const Word turns = lattice_.any_turn(node) >> node % L::points;
    unsigned better = 1;
    for (int k = 0;; k += stretch, better = 0) {
      DriveTime* times = &times_[index(node + k)];
      const DriveTime last = times[stretch - 1];
      const DriveTime* within = first_lanes + stretch - std::min(run - k + 1, stretch);
      for (int i = 0; i < stretch; i += width) {
        const Times old = load(times + i), now = load(straight.times + k + i) + time;
        const Times improves = (now < old) & load(within + i);
        store(times + i, (now & improves) | (old & ~improves));
        better |= bits_of(improves) << i;
      }
      let_turn(node + k, better & static_cast<unsigned>(turns >> k));
      // The earlier label is better than this one at all places further on.
      if (k + stretch > run || last <= time + straight.gain[k + stretch - 1]) return;
    }
  }

  /// Marks some of the nodes of a stretch: their turns will be tried, once each.
  void let_turn(int node, unsigned nodes) {
    driven_.add(node / L::points, static_cast<Word>(nodes) << node % L::points);
  }

  /// Tries the turns of all marked nodes, and keeps them where they are earlier than what is known. One time a node
  /// suffices: a mouse that rolls through a node before a turn could lead there is ahead of it at all places further
  /// on.
  template <class Bounds>
  void drive_turns(const Bounds& bounds) {
    turns_.clear();
    driven_.empty([&](int node) {
      turns_.add_ones(static_cast<TurnAt>(8 * node), turn_bits(lattice_, node));
      if (!turns_.takes(8)) drive_listed_turns(bounds);
    });
    drive_listed_turns(bounds);
  }
  template <class Bounds>
  void drive_listed_turns(const Bounds& bounds) {
    improved_.clear();
    for (const unsigned turn : turns_) {
      const std::uint16_t to = leaps_[turn];
      const DriveTime known = times_[to], gain = std::min<DriveTime>(times_[turn / 8] + turn_time(turn) - known, 0);
      times_[to] = known + gain;
      improved_.add(to, static_cast<unsigned>(gain) >> 31);
    }
    turns_.clear();
    for (const int improved : improved_) waiting_.add(improved, times_[index(improved)] + bounds[improved]);
  }

  /// Length of the list of turns.
  static constexpr int chunk = 512;

  const FixedTables& tables_;
  Size size_;
  const std::uint16_t* leaps_;
  KeptBounds<L::nodes>& kept_;
  int start_ = everywhere;
  L lattice_;
  /// Time to the end of a mouse that rolls through the reversed node.
  DriveTime* times_;
  Bounds<L::nodes> bounds_;             ///< lower bounds of the times from the start to the reversed node
  Buckets<L::nodes, 4> waiting_;        ///< nodes to which turns have led
  NodeSet<Word, 8 * L::lines> driven_;  ///< nodes to which straights have led
  List<TurnAt, chunk> turns_;
  List<std::uint16_t, chunk> improved_;
};

class FixedSearches final : public SearchMaker {
 public:
  FixedSearches(const DriveTables& tables, const Leaps& leaps) : tables_(tables), leaps_(leaps) {}

  SearchBytes bytes(Size size) const override {
    return is_small(size) ? bytes_of<std::uint32_t>() : bytes_of<std::uint64_t>();
  }
  std::size_t table_bytes() const override { return sizeof(tables_); }
  MemoryLayout layout(Size size) const override {
    return is_small(size) ? FixedSearch<std::uint32_t>::layout() : FixedSearch<std::uint64_t>::layout();
  }
  SearchInPlace make(Size size, std::byte* memory) const override {
    return is_small(size) ? made<std::uint32_t>(size, memory, small_) : made<std::uint64_t>(size, memory, large_);
  }
  void keep_bounds() override {
    small_.start_keeping();
    large_.start_keeping();
  }

 private:
  template <class Word>
  static SearchBytes bytes_of() {
    return {aligned(sizeof(FixedSearch<Word>)), aligned(sizeof(DriveTime) * FixedSearch<Word>::labels)};
  }
  template <class Word>
  SearchInPlace made(Size size, std::byte* memory, KeptBounds<Lattice<Word>::nodes>& kept) const {
    auto* const labels = new (memory + bytes_of<Word>().kept) DriveTime[FixedSearch<Word>::labels];
    return SearchInPlace(new (memory) FixedSearch<Word>(size, tables_, leaps_, kept, labels));
  }

  FixedTables tables_;
  const Leaps& leaps_;
  mutable KeptBounds<Lattice<std::uint32_t>::nodes> small_;
  mutable KeptBounds<Lattice<std::uint64_t>::nodes> large_;
};

}  // namespace

std::unique_ptr<SearchMaker> make_fixed_searches(const DriveTables& tables, const Leaps& leaps) {
  return std::make_unique<FixedSearches>(tables, leaps);
}

}  // namespace labmouse::drive
