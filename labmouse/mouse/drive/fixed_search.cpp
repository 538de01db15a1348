// The search for robots that have one speed at all nodes: one lane along the axes and one on the diagonals.
//
// It goes from the goals backwards in time, which is forwards over nodes turned round: turns and their times are the same
// both ways. A label of a turn is spread along the corridor ahead, several nodes at once; what it improves waits for its
// own turns.
#include <algorithm>

#include "labmouse/mouse/drive/search.hpp"
#include "labmouse/mouse/drive/vectors.hpp"

namespace labmouse::drive {
namespace {

template <class Word>
class FixedSearch final : public Search {
 public:
  using L = Lattice<Word>;

  explicit FixedSearch(const DriveTables& tables)
      : turned_(L::nodes, bucket_shift(tables)), driven_(L::nodes, bucket_shift(tables)) {
    for (unsigned diagonal = 0; diagonal < 2; ++diagonal) {
      const StraightTimes& table = diagonal != 0 ? tables.diagonal : tables.along;
      Straight& straight = straights_[diagonal];
      for (int units = 0; units <= StraightTimes::longest; ++units) straight.times[units] = table.at(units, 0, 0);
      find_gains(straight);
    }
    for (int units = 0; units <= StraightTimes::longest; ++units) finish_.times[units] = tables.finish_from(units, 0);
    find_gains(finish_);
    std::array<DriveTime, all_turns.size()> turn_times{};
    for (const DrivenTurn& turn : tables.turns) turn_times[static_cast<unsigned>(turn.turn)] = turn.time;
    for (unsigned direction = 0; direction < 8; ++direction)
      for (unsigned parity = 0; parity < 2; ++parity)
        for (unsigned bit = 0; bit < (direction % 2 == 0 ? 8U : 3U); ++bit)
          bit_times_[direction][parity][bit] =
              turn_times[static_cast<unsigned>(reversed(turn_of(bit, direction % 2 != 0, parity == 0)))];
  }

  void fill(Size size, const WallSet& passages, const CellSet& goals, int start) override {
    lattice_.build(size, passages);
    forget(times_);
    turned_.clear();
    driven_.clear();
    goals.for_each([&](Cell cell) {
      for (int direction = 0; direction < 8; direction += 2)
        spread(L::node({2 * cell.x + 1, 2 * cell.y + 1}, direction), 0, finish_);
    });
    // Without a start, one that is never reached.
    const DriveTime& enough = times_[start == everywhere ? times_.size() - 1 : index(L::opposite(start))];
    for (unsigned bucket = 0; bucket <= std::max(turned_.last(), driven_.last()) && bucket <= turned_.bucket(enough); ++bucket) {
      turned_.empty(bucket, [&](int node) {
        const DriveTime time = times_[index(node)];
        if (turned_.bucket(time) == bucket) spread(node, time, straights_[static_cast<unsigned>(node / L::plane) & 1U]);
      });
      driven_.empty(bucket, [&](int node) {
        if (driven_.bucket(times_[index(node)]) == bucket) turn(node);
      });
    }
  }

  DriveTime turning(int node, std::size_t, DriveTime limit) const override {
    if (rolling(node, 0) > limit) return no_time;
    DriveTime best = no_time;
    const auto direction = static_cast<unsigned>(node / L::plane);
    const DriveTime* times = bit_times_[direction][static_cast<unsigned>(node) & 1U];
    for (unsigned bits = turn_bits(lattice_, node); bits != 0; bits &= bits - 1) {
      const auto bit = static_cast<unsigned>(std::countr_zero(bits));
      best = std::min(best, times[bit] + rolling(leap(node, bit), 0));
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
  /// Nodes that are looked at together.
  static constexpr int stretch = 2 * width;

  /// From [stretch - n] on: n lanes of ones, and zeros.
  static constexpr DriveTime first_lanes[2 * stretch] = {-1, -1, -1, -1, -1, -1, -1, -1};

  /// Times by units, and how much later than a mouse that starts over after k units one that comes through is at least, at
  /// any place further on: the least of t(k + j) - t(j).
  struct Straight {
    DriveTime times[StraightTimes::longest + 1 + stretch]{};
    DriveTime gain[StraightTimes::longest + 1]{};
  };

  static std::size_t index(int node) { return static_cast<std::size_t>(node); }

  static void find_gains(Straight& straight) {
    for (int k = 0; k <= StraightTimes::longest; ++k) {
      straight.gain[k] = straight.times[k];
      for (int j = 1; k + j <= StraightTimes::longest; ++j)
        straight.gain[k] = std::min(straight.gain[k], straight.times[k + j] - straight.times[j]);
    }
  }

  /// A turn has led to this node: spreads the times of straights of all lengths from here, a stretch at a time, since few
  /// are longer. What is improved waits for its turns, and so does the node itself.
  void spread(int node, DriveTime time, const Straight& straight) {
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
      for (unsigned bits = better & static_cast<unsigned>(turns >> k); bits != 0; bits &= bits - 1) {
        const int i = std::countr_zero(bits);
        driven_.add_if_earlier(times[i], no_time, node + k + i);
      }
      // Whoever rolled here before is ahead of this one at all places further on.
      if (k + stretch > run || last <= time + straight.gain[k + stretch - 1]) return;
    }
  }

  /// A straight has led to this node: turns from here wherever that is earlier than what is known. A mouse that rolls
  /// through a node before a turn could lead there is ahead of it at all places further on, so one time a node will do.
  void turn(int node) {
    const DriveTime time = times_[index(node)];
    const auto direction = static_cast<unsigned>(node / L::plane);
    const DriveTime* times = bit_times_[direction][static_cast<unsigned>(node) & 1U];
    const std::uint16_t* leaps = &leaps_[8 * index(node)];
    for (unsigned bits = turn_bits(lattice_, node); bits != 0; bits &= bits - 1) {
      const auto bit = static_cast<unsigned>(std::countr_zero(bits));
      const int to = leaps[bit];
      const DriveTime then = time + times[bit], known = times_[index(to)];
      turned_.add_if_earlier(then, known, to);
      times_[index(to)] = std::min(then, known);
    }
  }

  L lattice_;
  std::span<const std::uint16_t> leaps_ = L::leaps();
  Straight straights_[2];
  Straight finish_;
  /// By direction, parity of the position and bit; of the turn as it is driven, from the new node to the old.
  DriveTime bit_times_[8][2][8]{};
  /// Of a mouse that rolls at a node, turned round, until the end.
  std::vector<DriveTime> times_ = std::vector<DriveTime>(static_cast<std::size_t>(L::nodes + stretch), no_time);
  Buckets turned_;  ///< nodes to which a turn has led
  Buckets driven_;  ///< nodes to which a straight has led
};

}  // namespace

std::unique_ptr<Search> make_fixed_search(Size size, const DriveTables& tables) {
  if (size.width <= 16 && size.height <= 16) return std::make_unique<FixedSearch<std::uint32_t>>(tables);
  return std::make_unique<FixedSearch<std::uint64_t>>(tables);
}

}  // namespace labmouse::drive
