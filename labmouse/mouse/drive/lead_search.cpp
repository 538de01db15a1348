// The search for robots whose turns have one speed each, and leads. Only turns have labels, so that it fits the memory
// of a mouse.
//
// It goes backwards from the goals, which is forwards over reversed nodes. A label is the time of a turn that begins at
// a node. When its time has come, it is taken along the corridor ahead, through every turn that could have ended there,
// to the nodes where those begin. The straight between has no label: its time is looked up.
#include <algorithm>
#include <cassert>

#include "labmouse/mouse/drive/lane_tables.hpp"
#include "labmouse/mouse/drive/lists.hpp"
#include "labmouse/mouse/drive/search.hpp"
#include "labmouse/mouse/drive/vectors.hpp"

namespace labmouse::drive {
namespace {

/// The tables of a robot as its searches use them.
struct LeadTables {
  explicit LeadTables(const DriveTables& tables) : robot(tables), lanes(tables, 1), shift(bucket_shift(tables)) {
    constexpr std::uint8_t every_slot = 0xff;
    for (unsigned kind = 0; kind < node_kinds; ++kind)
      for (unsigned bit = 0; bit < 8; ++bit)
        for (std::uint64_t turn = lanes.turns(kind, every_slot, 1U << bit); turn != 0; turn &= turn - 1) {
          assert((driven[kind] >> bit & 1U) == 0);
          turns[kind][bit] = *lanes.turn(kind, static_cast<unsigned>(std::countr_zero(turn)));
          driven[kind] |= 1U << bit;
          assert(!turns[kind][bit].more);
          assert(kind != edge_node || turns[kind][bit].slot == first_slot_a_speed[edge_node]);
        }
    start.assign((StraightTimes::longest + 1) * row_of(centre_node, 1), no_time);
    for (unsigned units = 0; units <= StraightTimes::longest; ++units)
      for (std::size_t lane = 0; lane < tables.along.count(); ++lane)
        if (const int slot = lanes.slot(units % 2 == 0 ? centre_node : edge_node, lane); slot != LaneTables::no_slot)
          start[units * row_of(centre_node, 1) + static_cast<unsigned>(slot)] =
              tables.start_to(static_cast<int>(units), lane);
  }

  const DriveTables& robot;
  LaneTables lanes;
  /// By kind of node: the turns that end there, by bit of the reversed node, and which bits have one.
  std::array<std::array<TurnBefore, 8>, node_kinds> turns{};
  std::array<unsigned, node_kinds> driven{};
  /// From the start to a turn: rows of its slots, by units.
  std::vector<DriveTime> start;
  int shift;
};

template <class Word>
class LeadSearch final : public Search {
 public:
  using L = Lattice<Word>;
  /// Along the axes five labels for each pair of an edge and the middle of a cell; three for a node of a diagonal; and
  /// a vector that may be read beyond the last label.
  static constexpr std::size_t labels = (4 * L::plane / 2) * 5 + 4 * L::plane * 3 + width;

  LeadSearch(Size size, const LeadTables& tables, const Leaps& leaps, DriveTime* labels_of_nodes)
      : tables_(tables), size_(size), leaps_(leaps.of<Word>()), waiting_(tables.shift), turning_(labels_of_nodes) {}

  void fill(const WallSet& passages, const CellSet& goals, int start, DriveTime /*limit*/) override {
    lattice_.build(size_, passages);
    goals_ = goals;
    forget(turning_, labels);
    waiting_.clear();
    goals.for_each([&](Cell cell) {
      for (int direction = 0; direction < 8; direction += 2) {
        const int node = L::node({2 * cell.x + 1, 2 * cell.y + 1}, direction);
        spread(node, 0, tables_.lanes.finish(lattice_.run(L::opposite(node)) / 2), lattice_.run(node));
      }
    });
    while (waiting_.advance(start == everywhere ? no_time : time_from(start)))
      waiting_.empty([&](int node) { spread(node); });
  }

  static MemoryLayout layout() {
    return {
        {"labels", sizeof(DriveTime) * labels}, {"lattice", sizeof(L)}, {"bounds", 0}, {"waiting", sizeof(waiting_)}};
  }

  DriveTime turning(int node, std::size_t lane, DriveTime) const override {
    const int slot = tables_.lanes.slot(kind_of(node), lane);
    return slot == LaneTables::no_slot ? no_time : turning_[label(L::opposite(node)) + static_cast<unsigned>(slot)];
  }
  DriveTime rolling(int node, std::size_t lane) const override {
    if (tables_.lanes.slot(kind_of(node), lane) == LaneTables::no_slot) return no_time;
    DriveTime best = is_diagonal(node) ? no_time : finish(node, lane);
    const StraightTimes& straights = is_diagonal(node) ? tables_.robot.diagonal : tables_.robot.along;
    for (Word places = places_of_turns(node, lattice_.run(node)); places != 0; places &= places - 1) {
      const int units = std::countr_zero(places);
      for (std::size_t to = 0; to < straights.count(); ++to) {
        const DriveTime straight = straights.at(units, lane, to);
        if (straight < best) best = std::min(best, straight + turning(node + units, to, no_time));
      }
    }
    return best;
  }
  int node(HalfPoint point, int direction) const override { return L::node(point, direction); }
  HalfPoint point(int node) const override { return L::point(node); }
  int direction(int node) const override { return L::direction(node); }
  bool passable(HalfPoint point) const override { return lattice_.passable(point); }
  int run(int node) const override { return lattice_.run(node); }
  unsigned turns(int node) const override { return turn_bits(lattice_, node); }
  int leap(int node, unsigned bit) const override { return leaps_[8 * index(node) + bit]; }

 private:
  static constexpr unsigned row = row_of(centre_node, 1);
  static_assert(row == width && row_of(diagonal_node, 1) == width);

  static std::size_t index(int node) { return static_cast<std::size_t>(node); }
  static bool is_diagonal(int node) { return (static_cast<unsigned>(node / L::plane) & 1U) != 0; }
  static unsigned kind_of(int node) {
    return is_diagonal(node) ? diagonal_node : centre_node & static_cast<unsigned>(node);
  }
  /// Index of the label of slot 0 of a node, which lies before its first label if its first slot is not 0. A whole
  /// vector there contains labels of the nodes about it.
  static std::size_t label(int node) {
    const auto plane = static_cast<unsigned>(node / L::plane), place = static_cast<unsigned>(node % L::plane);
    const std::size_t first = (plane / 2 * 11 + plane % 2 * 5) * L::plane / 2;
    if (plane % 2 != 0) return first + std::size_t{3} * place;
    return first + place / 2 * 5 + place % 2 - first_slot_a_speed[edge_node] * (1 - place % 2);
  }

  /// The least time to the middle of a goal straight ahead; no_time where there is none.
  DriveTime finish(int node, std::size_t lane) const {
    DriveTime best = no_time;
    const int run = lattice_.run(node);
    for (int units = 1 - node % 2; units <= run; units += 2) {
      const HalfPoint point = L::point(node + units);
      if (goals_.contains({(point.x - 1) / 2, (point.y - 1) / 2}))
        best = std::min(best, tables_.robot.finish_from(units, lane, (run - units) / 2));
    }
    return best;
  }

  /// The time from rest at a start, as far as it is known; no_time where it is not, or where no turn is needed.
  DriveTime time_from(int start) const {
    Times best = Times{} + no_time;
    for (Word places = places_of_turns(start, lattice_.run(start)); places != 0; places &= places - 1) {
      const auto units = static_cast<unsigned>(std::countr_zero(places));
      const Times time =
          load(&tables_.start[units * row]) + load(turning_ + label(L::opposite(start + static_cast<int>(units))));
      best = time < best ? time : best;
    }
    return std::min(std::min(best[0], best[1]), std::min(best[2], best[3]));
  }
  /// The nodes ahead of this one, up to `units` away, where a turn can begin.
  Word places_of_turns(int node, int units) const {
    const unsigned beyond = static_cast<unsigned>(L::points - 1 - units) % L::points;
    return (lattice_.any_turn(node) >> node % L::points) & static_cast<Word>(~Word{0}) >> beyond;
  }

  /// Spreads the labels of a node whose time has come. Labels beyond the range of the buckets are queued again.
  void spread(int node) {
    const unsigned kind = kind_of(node);
    for (unsigned slot = first_slot_a_speed[kind]; slot < end_slot_a_speed[kind]; ++slot) {
      const DriveTime time = turning_[label(node) + slot];
      if (waiting_.is_now(time))
        spread(node, time, tables_.lanes.straights(kind, slot),
               useful_units(node, time, tables_.lanes.slacks(kind, slot), tables_.lanes.reach()));
      else if (!waiting_.passed(time))
        waiting_.add(node, time);
    }
  }

  /// The greatest useful length of a straight to a turn. If another turn would do for all places farther away, only the
  /// places that are too near for that one are left.
  int useful_units(int node, DriveTime time, const DriveTime* slacks, int reach) const {
    const int run = lattice_.run(node);
    if (would_do(node, time, slacks)) return std::min(run, reach - 1);
    for (int units = 2; units + reach <= run; units *= 2)
      if (would_do(node + units, time, slacks += row)) return units + reach - 1;
    return run;
  }
  /// Whether a turn that begins at a node in another slot would do as well.
  bool would_do(int node, DriveTime time, const DriveTime* slacks) const {
    return bits_of(load(turning_ + label(node)) <= load(slacks) + time) != 0;
  }

  /// A turn begins here, or a run ends, `time` before the end: takes it over the straights that lead here, which are
  /// rows of times by units, and through the turns before those.
  void spread(int node, DriveTime time, const DriveTime* straights, int units) {
    for (Word places = places_of_turns(node, units); places != 0; places &= places - 1) {
      const auto unit = static_cast<unsigned>(std::countr_zero(places));
      drive_turns(node + static_cast<int>(unit), time, straights + unit * row);
    }
  }
  void drive_turns(int there, DriveTime time, const DriveTime* straights) {
    const unsigned kind = kind_of(there);
    for (unsigned bits = turn_bits(lattice_, there) & tables_.driven[kind]; bits != 0; bits &= bits - 1) {
      const auto bit = static_cast<unsigned>(std::countr_zero(bits));
      const TurnBefore& turn = tables_.turns[kind][bit];
      const int before = leaps_[8 * index(there) + bit];
      DriveTime& known = turning_[label(before) + turn.before];
      const DriveTime now = time + straights[turn.slot] + turn.time;
      if (now >= known) continue;
      known = now;
      waiting_.add(before, now);
    }
  }

  const LeadTables& tables_;
  Size size_;
  const std::uint16_t* leaps_;
  CellSet goals_;
  L lattice_;
  Buckets<L::nodes, 4> waiting_;  ///< nodes to which turns have led
  DriveTime* turning_;            ///< by label
};

class LeadSearches final : public SearchMaker {
 public:
  LeadSearches(const DriveTables& tables, const Leaps& leaps) : tables_(tables), leaps_(leaps) {}

  SearchBytes bytes(Size size) const override {
    return is_small(size) ? bytes_of<std::uint32_t>() : bytes_of<std::uint64_t>();
  }
  std::size_t table_bytes() const override {
    return sizeof(tables_) - sizeof(tables_.lanes) + tables_.lanes.bytes() + sizeof(DriveTime) * tables_.start.size();
  }
  MemoryLayout layout(Size size) const override {
    return is_small(size) ? LeadSearch<std::uint32_t>::layout() : LeadSearch<std::uint64_t>::layout();
  }
  SearchInPlace make(Size size, std::byte* memory) const override {
    return is_small(size) ? made<std::uint32_t>(size, memory) : made<std::uint64_t>(size, memory);
  }

 private:
  template <class Word>
  static SearchBytes bytes_of() {
    return {aligned(sizeof(LeadSearch<Word>)), aligned(sizeof(DriveTime) * LeadSearch<Word>::labels)};
  }
  template <class Word>
  SearchInPlace made(Size size, std::byte* memory) const {
    auto* const labels = new (memory + bytes_of<Word>().kept) DriveTime[LeadSearch<Word>::labels];
    return SearchInPlace(new (memory) LeadSearch<Word>(size, tables_, leaps_, labels));
  }

  LeadTables tables_;
  const Leaps& leaps_;
};

}  // namespace

std::unique_ptr<SearchMaker> make_lead_searches(const DriveTables& tables, const Leaps& leaps) {
  return std::make_unique<LeadSearches>(tables, leaps);
}

}  // namespace labmouse::drive
