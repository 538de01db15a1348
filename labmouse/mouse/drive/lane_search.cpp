// The search for robots of many speeds: a label for each lane of each node.
//
// Otherwise as in fixed_search.cpp, backwards from the goals. A label of a turn is spread along the corridor ahead into all
// lanes that a turn before it could have ended in, four at a time. Labels that wait are in one bucket each, and move to an
// earlier one when they improve.
#include <algorithm>

#include "labmouse/mouse/drive/lists.hpp"
#include "labmouse/mouse/drive/search.hpp"
#include "labmouse/mouse/drive/vectors.hpp"

namespace labmouse::drive {
namespace {

/// Labels by time: a doubly linked list for each bucket, so that a label can leave the one it is in.
class LabelQueue {
 public:
  LabelQueue(std::size_t labels, int shift) : shift_(shift), next_(labels), before_(labels) { clear(); }

  static constexpr std::uint32_t none = ~std::uint32_t{0};

  unsigned bucket(DriveTime time) const { return static_cast<unsigned>(time >> shift_); }
  /// Puts a label at its new time; at its old one it was waiting, unless that is no_time.
  void put(std::uint32_t label, DriveTime old, DriveTime now) {
    const unsigned from = bucket(old), to = bucket(now);
    if (from == to) return;
    if (old < no_time) take_out(label, from);
    std::uint32_t& head = heads_[to % 256];
    next_[label] = head;
    before_[label] = none;
    if (head != none) before_[head] = label;
    head = label;
    last_ = std::max(last_, to);
  }
  /// Takes one label out of a bucket; none where it is empty.
  std::uint32_t take(unsigned bucket) {
    const std::uint32_t label = heads_[bucket % 256];
    if (label != none) take_out(label, bucket);
    return label;
  }
  /// The latest bucket that has ever been in use since the last clear.
  unsigned last() const { return last_; }
  void clear() {
    heads_.fill(none);
    last_ = 0;
  }

 private:
  void take_out(std::uint32_t label, unsigned bucket) {
    const std::uint32_t before = before_[label], after = next_[label];
    (before == none ? heads_[bucket % 256] : next_[before]) = after;
    if (after != none) before_[after] = before;
  }

  int shift_;
  unsigned last_ = 0;
  std::array<std::uint32_t, 256> heads_{};
  std::vector<std::uint32_t> next_, before_;
};

template <class Word>
class LaneSearch final : public Search {
 public:
  using L = Lattice<Word>;

  LaneSearch(Size size, const DriveTables& tables)
      : size_(size),
        tables_(tables),
        lanes_((static_cast<int>(std::max(tables.along.count(), tables.diagonal.count())) + width - 1) / width * width),
        along_(tables.along, lanes_),
        diagonal_(tables.diagonal, lanes_),
        finish_(static_cast<std::size_t>((StraightTimes::longest + 1) * lanes_), no_time),
        rolling_(static_cast<std::size_t>(L::nodes * lanes_), no_time),
        turning_(rolling_),
        turns_waiting_(rolling_.size(), bucket_shift(tables) - 1),
        straights_waiting_(rolling_.size(), bucket_shift(tables) - 1) {
    for (int units = 0; units <= StraightTimes::longest; ++units)
      for (std::size_t lane = 0; lane < tables.along.count(); ++lane)
        finish_[static_cast<std::size_t>(units * lanes_) + lane] = tables.finish_from(units, lane);
    for (unsigned kind = 0; kind < 3; ++kind)
      for (unsigned bit = 0; bit < (kind == 2 ? 3U : 8U); ++bit) take_turns(tables, kind, bit);
  }

  void fill(const WallSet& passages, const CellSet& goals, int start) override {
    lattice_.build(size_, passages);
    forget(rolling_);
    forget(turning_);
    turns_waiting_.clear();
    straights_waiting_.clear();
    goals.for_each([&](Cell cell) {
      for (int direction = 0; direction < 8; direction += 2)
        spread(L::node({2 * cell.x + 1, 2 * cell.y + 1}, direction), 0, finish_.data(), lanes_);
    });
    for (unsigned bucket = 0; bucket <= std::max(turns_waiting_.last(), straights_waiting_.last()); ++bucket) {
      if (start != everywhere && bucket > turns_waiting_.bucket(time_from(start))) return;
      drive_straights(bucket);
      drive_turns(bucket);
    }
  }

  DriveTime turning(int node, std::size_t lane, DriveTime) const override { return turning_[label(L::opposite(node), lane)]; }
  DriveTime rolling(int node, std::size_t lane) const override { return rolling_[label(L::opposite(node), lane)]; }
  int node(HalfPoint point, int direction) const override { return L::node(point, direction); }
  HalfPoint point(int node) const override { return L::point(node); }
  int direction(int node) const override { return L::direction(node); }
  bool passable(HalfPoint point) const override { return lattice_.passable(point); }
  int run(int node) const override { return lattice_.run(node); }
  unsigned turns(int node) const override { return turn_bits(lattice_, node); }
  int leap(int node, unsigned bit) const override { return leaps_[8 * static_cast<std::size_t>(node) + bit]; }

 private:
  /// The times of straights before a turn of a lane: of all lanes that they can come from side by side.
  struct Straights {
    std::vector<DriveTime> times;
    std::size_t units_apart;

    Straights(const StraightTimes& table, int lanes) : units_apart(table.count() * static_cast<std::size_t>(lanes)) {
      times.assign((StraightTimes::longest + 1) * units_apart, no_time);
      for (int units = 0; units <= StraightTimes::longest; ++units)
        for (std::size_t to = 0; to < table.count(); ++to)
          for (std::size_t from = 0; from < table.count(); ++from)
            times[static_cast<std::size_t>(units) * units_apart + to * static_cast<std::size_t>(lanes) + from] =
                table.at(units, from, to);
    }
  };
  /// A turn that ended in a lane: the lane in which it began, and its time.
  struct Before {
    std::uint8_t bit = 0;
    std::uint8_t from = 0;
    DriveTime time = 0;
  };

  /// The time from rest at a start, as far as it is known; no_time where it is not, or where no turn is needed.
  DriveTime time_from(int start) const {
    DriveTime best = no_time;
    for (int units = 0, run = lattice_.run(start); units <= run; ++units)
      for (std::size_t lane = 0; lane < tables_.along.count(); ++lane)
        best = std::min(best, tables_.start_to(units, lane) + turning(start + units, lane, no_time));
    return best;
  }

  std::size_t label(int node, std::size_t lane) const {
    return static_cast<std::size_t>(node) * static_cast<std::size_t>(lanes_) + lane;
  }
  static unsigned kind_of(int node) {
    return node / L::plane % 2 != 0 ? 2U : static_cast<unsigned>(node) & 1U;
  }

  void take_turns(const DriveTables& tables, unsigned kind, unsigned bit) {
    const Turn driven = reversed(turn_of(bit, kind == 2, kind == 0));
    if (kind == 0 && bit > 1) return;
    for (const DrivenTurn& turn : tables.turns)
      if (turn.turn == driven) {
        before_[kind][turn.to].push_back({static_cast<std::uint8_t>(bit), turn.from, turn.time});
        bits_[kind][turn.to] |= 1U << bit;
      }
  }

  void drive_straights(unsigned bucket) {
    for (std::uint32_t taken; (taken = turns_waiting_.take(bucket)) != LabelQueue::none;) {
      const int node = static_cast<int>(taken) / lanes_;
      const std::size_t lane = taken % static_cast<unsigned>(lanes_);
      const Straights& straights = node / L::plane % 2 != 0 ? diagonal_ : along_;
      spread(node, turning_[taken], straights.times.data() + lane * static_cast<std::size_t>(lanes_),
             static_cast<int>(straights.units_apart));
    }
  }

  /// A turn begins here in some lane, this time before the end: spreads it over straights of all lengths that lead to it,
  /// whose times lie at `times`, a row of lanes each, so far apart.
  void spread(int node, DriveTime time, const DriveTime* times, int apart) {
    const int run = lattice_.run(node);
    for (int units = 0; units <= run; ++units, ++node, times += apart) {
      DriveTime* rolling = &rolling_[label(node, 0)];
      unsigned improved = 0;
      alignas(16) DriveTime known[max_lanes];
      for (int lane = 0; lane < lanes_; lane += width) {
        const Times old = load(rolling + lane);
        const Times then = load(times + lane) + time;
        const Times better = then < old;
        store(known + lane, old);
        store(rolling + lane, (then & better) | (old & ~better));
        improved |= bits_of(better) << lane;
      }
      if (improved != 0) await_turns(node, improved, known);
    }
  }

  void await_turns(int node, unsigned improved, const DriveTime* known) {
    const unsigned turns = turn_bits(lattice_, node);
    const auto& bits = bits_[kind_of(node)];
    for (; improved != 0; improved &= improved - 1) {
      const auto lane = static_cast<unsigned>(std::countr_zero(improved));
      const std::size_t place = label(node, lane);
      if ((bits[lane] & turns) != 0)
        straights_waiting_.put(static_cast<std::uint32_t>(place), known[lane], rolling_[place]);
    }
  }

  void drive_turns(unsigned bucket) {
    for (std::uint32_t taken; (taken = straights_waiting_.take(bucket)) != LabelQueue::none;) {
      const int node = static_cast<int>(taken) / lanes_;
      const unsigned turns = turn_bits(lattice_, node);
      for (const Before& before : before_[kind_of(node)][taken % static_cast<unsigned>(lanes_)]) {
        if ((turns >> before.bit & 1U) == 0) continue;
        const std::size_t to = label(leap(node, before.bit), before.from);
        const DriveTime then = rolling_[taken] + before.time;
        if (then >= turning_[to]) continue;
        turns_waiting_.put(static_cast<std::uint32_t>(to), turning_[to], then);
        turning_[to] = then;
      }
    }
  }

  static constexpr int max_lanes = 32;

  Size size_;
  const DriveTables& tables_;
  int lanes_;  ///< of a node: those of both kinds of straights, whichever are more, in whole vectors
  Straights along_;
  Straights diagonal_;
  std::vector<DriveTime> finish_;
  /// By kind of node (edge, centre, diagonal) and lane.
  std::array<std::array<std::vector<Before>, max_lanes>, 3> before_;
  std::array<std::array<unsigned, max_lanes>, 3> bits_{};
  L lattice_;
  std::span<const std::uint16_t> leaps_ = L::leaps();
  std::vector<DriveTime> rolling_;
  std::vector<DriveTime> turning_;
  LabelQueue turns_waiting_;
  LabelQueue straights_waiting_;
};

}  // namespace

std::unique_ptr<Search> make_lane_search(Size size, const DriveTables& tables) {
  if (size.width <= 16 && size.height <= 16) return std::make_unique<LaneSearch<std::uint32_t>>(size, tables);
  return std::make_unique<LaneSearch<std::uint64_t>>(size, tables);
}

}  // namespace labmouse::drive
