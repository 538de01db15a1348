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

bool is_undecided(const ComparedMouse& candidate) { return candidate.verdict == SequentialVerdict::undecided; }

bool any_undecided(const Compared& compared) {
  return std::any_of(compared.candidates.begin(), compared.candidates.end(), is_undecided);
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
    std::size_t begin = 0;
    while (!compared_.stopped && compared_.never_started.empty() && !is_over(compared_)) {
      begin = compared_.mazes;
      const Race race = race_from(begin);
      if (race.stopped || lacks_contests()) {
        compared_.stopped = true;
        break;
      }
      // Who started once has not failed to start in every contest.
      if (compared_.mazes == 0) compared_.never_started = never_started_lines(race);
      if (compared_.never_started.empty()) add(shares_of(race, begin));
      show(false);
      if (hooks_.advanced) hooks_.advanced(compared_);
    }
    if (lacks_contests() && !compared_.exact) look_ahead(begin);
    return finished();
  }

  Compared judge(const std::vector<MazeShares>& shares) && {
    add(shares);
    return finished();
  }

  std::vector<MazeShares> batch_shares(std::size_t begin) const {
    const Race race = race_from(begin);
    return race.stopped ? std::vector<MazeShares>() : shares_of(race, begin);
  }

 private:
  /// The result, without the store, which ends with the race.
  Compared finished() {
    if (compared_.exact)
      for (ComparedMouse& candidate : compared_.candidates) decide_exactly(candidate);
    else
      show(true);
    compared_.order.race.store.reset();
    return std::move(compared_);
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

  bool lacks_contests() const { return hooks_.lacks_contests && hooks_.lacks_contests(); }

  /// The size of the batch that begins with the maze of that number.
  std::size_t count_from(std::size_t begin) const {
    return compared_.exact ? compared_.order.mazes.list.size() : std::min(batch, compared_.order.most - begin);
  }

  /// The mazes of that batch, in the order of drawing.
  std::vector<NamedMaze> mazes_from(std::size_t begin) const {
    if (compared_.exact) return compared_.order.mazes.list;
    std::vector<NamedMaze> mazes;
    for (std::size_t i = 0; i < count_from(begin); ++i)
      mazes.push_back(drawn_maze(compared_.order.mazes, compared_.order.race.seed, begin + i));
    return mazes;
  }

  /// Races in that batch, without the mazes that the world refuses.
  Race race_from(std::size_t begin) const {
    RaceOrder order = compared_.order.race;
    std::vector<NamedMaze> mazes = mazes_from(begin);
    if (!compared_.exact) {
      order.seed = seed_for(order.seed, "contests", begin);
      order.first_told = begin;
      std::erase_if(mazes, [&](const NamedMaze& maze) { return !order.world->refuse(maze.maze).empty(); });
    }
    std::vector<Contestant> mice = {mice_.front()};
    for (std::size_t i = 0; i < tests_.size(); ++i)
      if (is_undecided(compared_.candidates[i])) mice.push_back(mice_[i + 1]);
    RaceHooks hooks;
    hooks.stop = hooks_.stop;
    return hold_race(std::move(mice), std::move(mazes), order, hooks);
  }

  /// Lets the store see the contests of as many mazes as were raced in.
  void look_ahead(std::size_t begin) const {
    const std::size_t end = std::min(compared_.order.most, 2 * begin);
    for (std::size_t ahead = begin + batch; ahead < end; ahead += batch) static_cast<void>(race_from(ahead));
  }

  /// The shares of a race in that batch. The race has its mazes by name, which is in the order of drawing; those that
  /// it lacks come last.
  std::vector<MazeShares> shares_of(const Race& race, std::size_t begin) const {
    std::vector<MazeShares> shares(count_from(begin), MazeShares(mice_.size()));
    for (std::size_t i = 0; i < mice_.size(); ++i)
      for (const ContestResult& contest : race.results)
        if (race.mice[contest.mouse].name == mice_[i].name) shares[contest.maze][i] = share_of_best(race, contest);
    return shares;
  }

  void add(const std::vector<MazeShares>& shares) {
    for (const MazeShares& maze : shares)
      if (any_undecided(compared_)) add(maze);
  }

  void add(const MazeShares& shares) {
    ++compared_.mazes;
    bool used = false;
    for (std::size_t i = 0; i < tests_.size(); ++i) {
      ComparedMouse& candidate = compared_.candidates[i];
      const auto &first = shares.front(), &share = shares[i + 1];
      if (!is_undecided(candidate) || !first || !share) continue;
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

std::size_t batch_with(std::size_t number) { return number / batch * batch; }

std::size_t batch_of(std::string_view name) {
  return batch_with(parse_whole<std::size_t>(name.substr(0, name.find('-'))).value_or(0));
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

std::vector<MazeShares> shares_of_batch(std::vector<Contestant> mice, const CompareOrder& order,
                                        const BatchOrder& part) {
  CompareHooks hooks;
  hooks.stop = part.stop;
  return Comparing(std::move(mice), order, hooks).batch_shares(part.begin);
}

Compared judged(std::vector<Contestant> mice, const CompareOrder& order, const std::vector<MazeShares>& shares) {
  return Comparing(std::move(mice), order, {}).judge(shares);
}

bool is_over(const Compared& compared) {
  return !any_undecided(compared) || compared.mazes >= compared.order.most ||
         (compared.mazes > 0 && (compared.exact || compared.skipped == compared.mazes));
}

}  // namespace labmouse
