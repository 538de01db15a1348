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
      : turns_waiting_(L::nodes, bucket_shift(tables)), straights_waiting_(L::nodes, bucket_shift(tables)) {
    for (unsigned diagonal = 0; diagonal < 2; ++diagonal) {
      const StraightTimes& table = diagonal != 0 ? tables.diagonal : tables.along;
      Straight& straight = straights_[diagonal];
      for (int units = 0; units <= StraightTimes::longest; ++units) straight.times[units] = table.at(units, 0, 0);
      find_gains(straight);
    }
    for (int units = 0; units <= StraightTimes::longest; ++units) finish_.times[units] = tables.finish_from(units, 0);
    find_gains(finish_);
    for (const DrivenTurn& turn : tables.turns) turn_times_[static_cast<unsigned>(turn.turn)] = turn.time;
    for (unsigned kind = 0; kind < 3; ++kind)
      for (unsigned bit = 0; bit < 8; ++bit)
        if (kind != 2 || bit < 3)
          bit_times_[kind][bit] = turn_times_[static_cast<unsigned>(reversed(turn_of(bit, kind == 2, kind == 0)))];
  }

  void fill(Size size, const WallSet& passages, const CellSet& goals) override {
    lattice_.build(size, passages);
    std::fill(rolling_.begin(), rolling_.end(), no_time);
    std::fill(turning_.begin(), turning_.end(), no_time);
    turns_waiting_.clear();
    straights_waiting_.clear();
    goals.for_each([&](Cell cell) {
      for (int direction = 0; direction < 8; direction += 2)
        spread(L::node({2 * cell.x + 1, 2 * cell.y + 1}, direction), 0, finish_);
    });
    unsigned bucket = 0;
    while ((bucket = std::min(turns_waiting_.next(bucket), straights_waiting_.next(bucket))) != Buckets::none) {
      drive_straights(bucket);
      drive_turns(bucket);
      ++bucket;
    }
  }

  DriveTime turning(int node, std::size_t) const override { return turning_[index(L::opposite(node))]; }
  DriveTime rolling(int node, std::size_t) const override { return rolling_[index(L::opposite(node))]; }
  int node(HalfPoint point, int direction) const override { return L::node(point, direction); }
  HalfPoint point(int node) const override { return L::point(node); }
  bool passable(HalfPoint point) const override { return lattice_.passable(point); }
  int leap(int node, unsigned bit) const override {
    if ((lattice_.turns_at(node) >> bit & 1U) == 0) return -1;
    return leap_of(node, bit);
  }

 private:
  /// Nodes that are looked at together.
  static constexpr int stretch = 2 * width;

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

  void drive_straights(unsigned bucket) {
    const std::uint16_t* waiting = turns_waiting_.begin(bucket);
    for (unsigned i = 0, count = turns_waiting_.length(bucket); i < count; ++i) {
      const int node = waiting[i];
      const DriveTime time = turning_[index(node)];
      // Somebody passes here earlier, and is rolling already.
      if (rolling_[index(node)] <= time) continue;
      spread(node, time, straights_[static_cast<unsigned>(node / L::plane) & 1U]);
    }
    turns_waiting_.empty(bucket);
  }

  /// A turn has led to this node: spreads the times of straights of all lengths from here, a stretch at a time, since few
  /// are longer.
  void spread(int node, DriveTime time, const Straight& straight) {
    const int run = lattice_.run(node);
    const Word turns = lattice_.any_turn(node) >> node % L::points;
    for (int k = 0;; k += stretch) {
      DriveTime* rolling = &rolling_[index(node + k)];
      alignas(16) DriveTime known[stretch], then[stretch];
      unsigned better = 0;
      for (int i = 0; i < stretch; i += width) {
        const Times old = load(rolling + i), now = load(straight.times + k + i) + time;
        const Times improves = (now < old) & (Times{0, 1, 2, 3} + (k + i) <= run);
        store(known + i, old);
        store(then + i, now);
        store(rolling + i, (now & improves) | (old & ~improves));
        better |= bits_of(improves) << i;
      }
      for (unsigned bits = better & static_cast<unsigned>(turns >> k); bits != 0; bits &= bits - 1) {
        const int i = std::countr_zero(bits);
        const unsigned bucket = straights_waiting_.bucket(then[i]);
        straights_waiting_.add_if(straights_waiting_.bucket(known[i]) != bucket, bucket, node + k + i);
      }
      // Whoever rolled here before is ahead of this one at all places further on.
      if (k + stretch > run || known[stretch - 1] <= time + straight.gain[k + stretch - 1]) return;
    }
  }

  void drive_turns(unsigned bucket) {
    const std::uint16_t* waiting = straights_waiting_.begin(bucket);
    for (unsigned i = 0, count = straights_waiting_.length(bucket); i < count; ++i) {
      const int node = waiting[i];
      const DriveTime time = rolling_[index(node)];
      if (straights_waiting_.bucket(time) != bucket) continue;  // it has been improved since, and was driven then
      const int position = node % L::points;
      const auto direction = static_cast<unsigned>(node / L::plane);
      const int odd_line = 2 * (node / L::points % L::lines) + 1;
      const auto& leaps = leaps_[direction][static_cast<unsigned>(position) & 1U];
      const DriveTime* times = bit_times_[direction % 2 != 0 ? 2 : static_cast<unsigned>(position) & 1U];
      for (unsigned bits = turn_bits(lattice_, node); bits != 0; bits &= bits - 1) {
        const auto bit = static_cast<unsigned>(std::countr_zero(bits));
        const int to = leaps[bit].to(odd_line, position);
        const DriveTime then = time + times[bit], known = turning_[index(to)];
        const bool better = then < std::min(known, rolling_[index(to)]);
        const unsigned place = turns_waiting_.bucket(then);
        turning_[index(to)] = better ? then : known;
        turns_waiting_.add_if(better && turns_waiting_.bucket(known) != place, place, to);
      }
    }
    straights_waiting_.empty(bucket);
  }

  int leap_of(int node, unsigned bit) const {
    const auto direction = static_cast<unsigned>(node / L::plane);
    const auto parity = static_cast<unsigned>(node) & 1U;
    return leaps_[direction][parity][bit].to(2 * (node / L::points % L::lines) + 1, node % L::points);
  }

  L lattice_;
  const typename L::Leaps& leaps_ = L::leaps();
  Straight straights_[2];
  Straight finish_;
  DriveTime turn_times_[8]{};
  /// By kind of node (edge, centre, diagonal) and bit; of the turn as it is driven, from the new node to the old.
  DriveTime bit_times_[3][8]{};
  std::vector<DriveTime> rolling_ = std::vector<DriveTime>(static_cast<std::size_t>(L::nodes + stretch), no_time);
  std::vector<DriveTime> turning_ = std::vector<DriveTime>(static_cast<std::size_t>(L::nodes), no_time);
  Buckets turns_waiting_;
  Buckets straights_waiting_;
};

}  // namespace

std::unique_ptr<Search> make_fixed_search(Size size, const DriveTables& tables) {
  if (size.width <= 16 && size.height <= 16) return std::make_unique<FixedSearch<std::uint32_t>>(tables);
  return std::make_unique<FixedSearch<std::uint64_t>>(tables);
}

}  // namespace labmouse::drive
