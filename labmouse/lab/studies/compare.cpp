#include "labmouse/lab/studies/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "labmouse/chance/rng.hpp"
#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/races/never_started.hpp"
#include "labmouse/lab/standings/standings.hpp"

namespace labmouse {
namespace {

/// So many mazes are raced in at once: enough for many threads, few to be held in vain after the last verdict.
constexpr std::size_t batch = 32;

/// Whether one contest in each maze of the list is all that there is. Whether external mice are stochastic is unknown.
bool is_exact(const std::vector<Contestant>& mice, const CompareOrder& order) {
  return !order.mazes.list.empty() && order.mazes.list.size() <= order.most &&
         !order.race.world->traits().is_stochastic &&
         std::none_of(mice.begin(), mice.end(),
                      [](const Contestant& mouse) { return mouse.external || mouse.uses_chance; });
}

/// The contest of a mouse in a maze, in a race with one in each.
const ContestResult& contest_in(const Race& race, std::string_view mouse, std::size_t maze) {
  return *std::find_if(race.results.begin(), race.results.end(), [&](const ContestResult& contest) {
    return contest.maze == maze && race.mice[contest.mouse].name == mouse;
  });
}

class Comparing {
 public:
  Comparing(std::vector<Contestant> mice, const CompareOrder& order, const CompareHooks& hooks)
      : mice_(std::move(mice)),
        hooks_(hooks),
        tests_(mice_.size() - 1, SequentialTest(order_of_each(order.test, mice_.size() - 1))),
        sums_(tests_.size()) {
    compared_.order = order;
    compared_.order.race.runs = 1;
    compared_.order.race.shard = {};
    compared_.first = mice_.front().name;
    for (Contestant& mouse : mice_) mouse.runs = 1;
    compared_.exact = is_exact(mice_, compared_.order);
    hide_list();
    for (std::size_t i = 1; i < mice_.size(); ++i) compared_.candidates.push_back({mice_[i].name});
  }

  Compared hold() && {
    const std::vector<NamedMaze>& list = compared_.order.mazes.list;
    if (compared_.order.part) {
      static_cast<void>(compared_.exact
                            ? race_in(list, compared_.order.race)
                            : race_in(mazes_from(*compared_.order.part), order_from(*compared_.order.part)));
      compared_.stopped = true;
      return finished();
    }
    if (compared_.exact) {
      add(race_in(list, compared_.order.race));
      for (ComparedMouse& candidate : compared_.candidates) decide_exactly(candidate);
      return finished();
    }
    std::size_t begin = 0;
    while (compared_.mazes < compared_.order.most && is_undecided() && !is_pointless()) {
      begin = compared_.mazes;
      race_from(begin);
      show(false);
      if (hooks_.advanced) hooks_.advanced(compared_);
    }
    if (lacks()) look_ahead(begin);
    show(true);
    return finished();
  }

 private:
  /// The result, without the store, which ends with the race.
  Compared finished() {
    compared_.order.race.store.reset();
    return std::move(compared_);
  }

  /// Whether no maze so far counted, or there will be no more.
  bool is_pointless() const {
    return compared_.stopped || !compared_.never_started.empty() ||
           (compared_.mazes > 0 && compared_.skipped == compared_.mazes);
  }

  struct Sums {
    double share = 0.0, first_share = 0.0;
    std::size_t shown = 0;  ///< pairs of the interval that was computed last
  };

  /// Hides the list from external mice: races know drawn mazes by other names.
  void hide_list() const {
    for (const Contestant& mouse : mice_)
      if (mouse.hidden)
        for (const NamedMaze& maze : compared_.order.mazes.list) mouse.hidden->add_if_there(maze.name);
  }

  bool is_undecided() const {
    return std::any_of(compared_.candidates.begin(), compared_.candidates.end(), [](const ComparedMouse& candidate) {
      return candidate.verdict == SequentialVerdict::undecided;
    });
  }

  bool lacks() const { return hooks_.lacks && hooks_.lacks(); }

  /// The size of the batch that begins with the maze of that number.
  std::size_t count_from(std::size_t begin) const { return std::min(batch, compared_.order.most - begin); }

  RaceOrder order_from(std::size_t begin) const {
    RaceOrder order = compared_.order.race;
    order.seed = seed_for(order.seed, "contests", begin);
    order.first_told = begin;
    return order;
  }

  /// The mazes of that batch, without those that the world refuses.
  std::vector<NamedMaze> mazes_from(std::size_t begin) const {
    std::vector<NamedMaze> mazes;
    for (std::size_t i = 0; i < count_from(begin); ++i) {
      NamedMaze maze = drawn_maze(compared_.order.mazes, compared_.order.race.seed, begin + i);
      if (compared_.order.race.world->refuse(maze.maze).empty()) mazes.push_back(std::move(maze));
    }
    return mazes;
  }

  void race_from(std::size_t begin) {
    std::vector<NamedMaze> mazes = mazes_from(begin);
    const std::size_t refused = count_from(begin) - mazes.size();
    add(race_in(std::move(mazes), order_from(begin)));
    compared_.mazes += refused;
    compared_.skipped += refused;
  }

  /// Lets the store see the contests of as many mazes as were raced in.
  void look_ahead(std::size_t begin) const {
    const std::size_t end = std::min(compared_.order.most, 2 * begin);
    for (std::size_t ahead = begin + batch; ahead < end; ahead += batch)
      static_cast<void>(race_in(mazes_from(ahead), order_from(ahead)));
  }

  Race race_in(std::vector<NamedMaze> mazes, const RaceOrder& order) const {
    std::vector<Contestant> mice = {mice_.front()};
    for (std::size_t i = 0; i < tests_.size(); ++i)
      if (compared_.candidates[i].verdict == SequentialVerdict::undecided) mice.push_back(mice_[i + 1]);
    RaceHooks hooks;
    hooks.stop = hooks_.stop;
    return hold_race(std::move(mice), std::move(mazes), order, hooks);
  }

  void add(const Race& race) {
    if (race.stopped || lacks()) {
      compared_.stopped = true;
      return;
    }
    // Who started once has not failed to start in every contest.
    if (compared_.mazes == 0) compared_.never_started = never_started_lines(race);
    if (!compared_.never_started.empty()) return;
    // The race has them by name, which is in the order of drawing.
    for (std::size_t maze = 0; maze < race.mazes.size() && is_undecided(); ++maze) add(race, maze);
  }

  void add(const Race& race, std::size_t maze) {
    ++compared_.mazes;
    const auto first = share_of_best(race, contest_in(race, compared_.first, maze));
    bool used = false;
    for (std::size_t i = 0; i < tests_.size(); ++i) {
      ComparedMouse& candidate = compared_.candidates[i];
      if (candidate.verdict != SequentialVerdict::undecided || !first) continue;
      const auto share = share_of_best(race, contest_in(race, candidate.mouse, maze));
      if (!share) continue;
      used = true;
      sums_[i].share += *share;
      sums_[i].first_share += *first;
      const auto pairs = static_cast<double>(++candidate.pairs);
      candidate.share = sums_[i].share / pairs;
      candidate.first_share = sums_[i].first_share / pairs;
      candidate.difference = candidate.share - candidate.first_share;
      if (compared_.exact) continue;
      tests_[i].add(*share - *first);
      candidate.verdict = tests_[i].verdict();
    }
    compared_.skipped += used ? 0 : 1;
  }

  static void decide_exactly(ComparedMouse& candidate) {
    constexpr double rounding = 1e-12;
    if (candidate.pairs == 0) return;
    candidate.interval = {candidate.difference, candidate.difference};
    candidate.verdict = candidate.difference > rounding    ? SequentialVerdict::better
                        : candidate.difference < -rounding ? SequentialVerdict::worse
                                                           : SequentialVerdict::no_difference;
  }

  /// Computes the intervals, which takes longer the more pairs there are: at the end, and where a tenth was added.
  void show(bool at_the_end) {
    for (std::size_t i = 0; i < tests_.size(); ++i) {
      const std::size_t pairs = compared_.candidates[i].pairs;
      if (pairs == sums_[i].shown || (!at_the_end && pairs < sums_[i].shown + sums_[i].shown / 10)) continue;
      sums_[i].shown = pairs;
      compared_.candidates[i].interval = including(tests_[i].interval(), compared_.candidates[i].difference);
    }
  }

  std::vector<Contestant> mice_;
  const CompareHooks& hooks_;
  std::vector<SequentialTest> tests_;
  std::vector<Sums> sums_;
  Compared compared_;
};

}  // namespace

NamedMaze drawn_maze(const MazeSource& source, std::uint64_t seed, std::size_t number) {
  // Sorted by name they are in the order of drawing. The number gives each contest a seed of its own.
  const auto named = [&](std::string_view name) { return fmt::format("{:07}-{}", number, name); };
  if (source.list.empty()) {
    GeneratorOrder order = source.order;
    order.seed = seed_for(seed, "maze", number);
    return {named(source.generator->name), source.generator->make(order)};
  }
  const auto among = Rng(seed_for(seed, "drawn", number)).below(static_cast<int>(source.list.size()));
  NamedMaze maze = source.list[static_cast<std::size_t>(among)];
  maze.name = named(maze.name.substr(maze.name.rfind('/') + 1));
  return maze;
}

std::size_t batch_of(std::string_view name) {
  const auto number = parse_whole<std::size_t>(name.substr(0, name.find('-')));
  return number.value_or(0) / batch * batch;
}

SequentialOrder order_of_each(const SequentialOrder& order, std::size_t candidates) {
  SequentialOrder each = order;
  each.alpha /= static_cast<double>(candidates);
  each.beta /= static_cast<double>(candidates);
  return each;
}

Compared hold_comparison(std::vector<Contestant> mice, const CompareOrder& order, const CompareHooks& hooks) {
  return Comparing(std::move(mice), order, hooks).hold();
}

}  // namespace labmouse
