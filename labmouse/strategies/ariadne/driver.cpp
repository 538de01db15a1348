#include "labmouse/strategies/ariadne/driver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "labmouse/mouse/drive/drive_fields.hpp"
#include "labmouse/mouse/drive/route_passages.hpp"
#include "labmouse/mouse/drive/run_prices.hpp"
#include "labmouse/mouse/driving_explorer.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/runs.hpp"
#include "labmouse/mouse/ways.hpp"
#include "labmouse/strategies/ariadne/drive_policy.hpp"
#include "labmouse/strategies/ariadne/outlook.hpp"

namespace labmouse::ariadne {
namespace {

/// A wall's price is its reluctance, -ln P(open) in 1/32.
constexpr PriceTable reluctances = [] {
  PriceTable table{};
  for (unsigned reluctance = 0; reluctance < table.size(); ++reluctance)
    table[reluctance] = static_cast<std::uint8_t>(std::min<int>(static_cast<int>(reluctance), WallPrices::highest));
  return table;
}();
constexpr double probability_of_one = 0.96923323447634413;  // exp(-1 / 32)
constexpr auto probabilities = [] {
  std::array<double, 1024> table{};
  table[0] = 1.0;
  for (std::size_t i = 1; i < table.size(); ++i) table[i] = table[i - 1] * probability_of_one;
  return table;
}();
/// exp(-n / 32), the same on every platform.
double probability(int reluctance) {
  constexpr int most = static_cast<int>(probabilities.size()) - 1;
  double probability = probabilities[static_cast<std::size_t>(std::clamp(reluctance, 0, most))];
  for (; reluctance > most; --reluctance) probability *= probability_of_one;
  return probability;
}

DriveTime part(double factor, DriveTime time) { return static_cast<DriveTime>(factor * time); }

/// The times of the parts of speed runs. They are measured in corridors of a maze of at least run_prices_side each
/// way, in the briefing's memory if its maze is that large.
RunPrices run_prices(const Briefing& briefing) {
  if (std::min(briefing.size.width, briefing.size.height) >= run_prices_side)
    return run_prices_of(briefing.drive.fields->routes());
  FastestRoutes routes({run_prices_side, run_prices_side}, route_tables_of(*briefing.drive.model));
  return run_prices_of(routes);
}

class Driver final : public DrivingExplorer {
 public:
  Driver(const Briefing& briefing, const Settings& settings, const WallPrior* prior)
      : DrivingExplorer(briefing),
        policy_(settings),
        search_(briefing.drive.model->search),
        prior_(prior),
        outlook_(this->briefing(), prior),
        routes_(std::in_place, this->briefing()),
        likely_(briefing.size.area() <= RunCosts::largest_area),
        least_part_(likely_ ? policy_.hope_gain : 0),
        ways_(this->briefing().drive.fields->ways()),
        savings_(static_cast<std::size_t>(briefing.size.area()), part(policy_.way_news, search_.cell)) {
    outlook_.price(reluctances);
    if (!likely_) return;
    runs_ = &this->briefing().drive.fields->runs();
    runs_->aim(run_prices(this->briefing()), briefing.start, briefing.goals);
  }

 private:
  Action explore() override {
    if (outlook_.learn(knowledge())) news_ = true;
    if (!goal_entered()) return to_goal();
    if (std::exchange(news_, false)) {
      next_.reset();
      runs_ != nullptr ? save() : forget_known_cells();
    }
    // Without a known run there is no gain to compare with.
    return weighs() && knows_run() ? home() : look();
  }

  /// Clears all readings and routes.
  void renew() override {
    outlook_ = Outlook(briefing(), prior_);
    outlook_.price(reluctances);
    routes_->forget();
    news_ = true;
  }

  bool knows_run() { return runs_ != nullptr ? known_ != RunCosts::no_run : known_time(no_time) != no_time; }

  /// Time of the fastest known route; no_time if that is above the limit. It changes only with passages outside of dead
  /// ends.
  DriveTime known_time(DriveTime limit) {
    const WallSet passages =
        passages_of_routes(briefing().size, knowledge().open(), briefing().start.cell, briefing().goals);
    if (timed_passages_ != passages || (known_time_ == no_time && known_limit_ < limit)) {
      timed_passages_ = passages;
      known_limit_ = limit;
      known_time_ = routes_->known_time(knowledge(), limit);
    }
    return known_time_;
  }

  /// Whether the maze time counts, so that a look costs score.
  bool weighs() const { return briefing().drive.maze_time_divisor > 0; }

  bool is_early() const {
    const auto limit = static_cast<double>(briefing().drive.time_limit);
    return limit - static_cast<double>(time_left()) < policy_.corner_time * limit;
  }

  Action to_goal() {
    count_plan();
    SearchDrive moves = search_;
    if (weighs() || is_early()) moves.turn = std::min(search_.turn, part(policy_.corner_turn, search_.cell));
    const SearchPlace here = place();
    ways_.fill(moves, knowledge().possible(), knowledge().known_cells(), briefing().goals, &here);
    return hopeful_step(ways_, knowledge(), here);
  }

  Action home() {
    if (pose().cell == briefing().start.cell) return Action::reset();
    SearchTolls tolls{search_};
    tolls.drive.turn = part(policy_.home_turn, search_.turn);
    tolls.drive.back = part(policy_.home_back, search_.back);
    tolls.unit = part(policy_.home_cells_a_nat / 32, search_.cell);
    tolls.base = part(policy_.home_cells_a_wall, search_.cell);
    tolls.closed = policy_.home_closed;
    if (runs_ != nullptr) tolls.savings = savings_;
    return step_towards(CellSet::of(briefing().start.cell), tolls);
  }

  /// Goes to where the next unseen wall of the best possible route can be seen, as certify does.
  Action look() {
    if (routes_->plan(hope(), knowledge())) count_plan();
    if (enough() && likely_) hope_for_all();
    if (enough()) return Action::reset();
    const CellSet viewpoints = viewpoints_of(routes_->unknown_walls(), knowledge(), briefing().sight);
    // At a viewpoint and still unseen: the wall is behind the mouse.
    if (viewpoints.contains(pose().cell)) return Action::step(90, 0);
    SearchTolls tolls{search_};
    if (runs_ != nullptr) tolls.unit = part(policy_.way_cells_a_nat / 32, search_.cell);
    if (runs_ != nullptr || has_time_for_all()) tolls.savings = savings_;
    return step_towards(viewpoints, tolls);
  }

  /// Whether the best possible route is known, or would save too little.
  bool enough() {
    if (routes_->proven()) return true;
    if (least_part_ == 0 || !knows_run()) return false;
    int reluctance = 0;
    routes_->unknown_walls().for_each([&](Wall wall) { reluctance += outlook_.prices().of(wall); });
    const double trust = likely_ ? probability(static_cast<int>(policy_.hope_chance * reluctance)) : 1;
    // The longer the known route, the more another one would save: beyond this time that is enough, with a millisecond
    // for errors of rounding.
    const DriveTime best = routes_->optimistic_time();
    const double longest = trust > least_part_ ? trust * best / (trust - least_part_) + 1000 : no_time;
    const auto limit = static_cast<DriveTime>(std::min<double>(longest, no_time));
    const DriveTime known = known_time(limit);
    return known != no_time && trust * (known - best) < least_part_ * known;
  }

  /// From now on considers routes through unlikely walls, too, but only for large gains.
  void hope_for_all() {
    likely_ = false;
    least_part_ = policy_.last_gain;
    routes_.emplace(briefing());
    routes_->plan(hope(), knowledge());
    count_plan();
  }

  /// The passages of possible routes: all that may be open, or only those likely enough to be.
  WallSet hope() const {
    WallSet walls = knowledge().possible();
    if (!likely_) return walls;
    knowledge().unknown().for_each([&](Wall wall) {
      if (outlook_.prices().of(wall) >= policy_.hope_closed) walls.erase(wall);
    });
    return walls;
  }

  /// Without news, cells and tolls are those of the last call, and its plan holds for the places to which it leads.
  Action step_towards(const CellSet& cells, const SearchTolls& tolls) {
    const SearchPlace here = place();
    if (next_ != here) ways_.fill(outlook_.prices(), tolls, knowledge().known_cells(), cells, &here);
    const Action step = hopeful_step(ways_, knowledge(), here);
    next_.reset();
    if (ways_.keeps() && step.kind == Action::Kind::step && step.movement > 0) next_ = after_search(here, step);
    return step;
  }

  /// Whether the mouse could enter each cell in the time allowed.
  bool has_time_for_all() const {
    return static_cast<std::int64_t>(briefing().size.area()) * search_.cell <= briefing().drive.time_limit;
  }

  /// Entering a known cell shows nothing new, so it saves nothing.
  void forget_known_cells() {
    knowledge().known_cells().for_each(
        [&](Cell cell) { savings_[static_cast<std::size_t>(briefing().size.index(cell))] = 0; });
  }

  /// Computes the worth of entering each unseen cell: the gain of the best run through it, times the probability that
  /// it exists.
  void save() {
    count_plan();
    const WallSet passages = passages_without_price();
    if (known_passages_ != passages) known_ = runs_->known(outlook_.prices());
    known_passages_ = passages;
    const bool any = known_ == RunCosts::no_run;
    const RunTolls tolls{policy_.run_a_nat, policy_.run_a_wall, policy_.run_closed};
    const int longest =
        any ? RunCosts::no_run : std::min<int>(RunCosts::no_run, static_cast<int>(policy_.run_longest * known_));
    runs_->plan(outlook_.prices(), tolls, longest);
    const CellSet known_cells = knowledge().known_cells();
    CellSet::all(briefing().size).for_each([&](Cell cell) {
      savings_[static_cast<std::size_t>(briefing().size.index(cell))] = known_cells.contains(cell) ? 0 : saving(cell);
    });
  }

  /// The passages that a known run may take.
  WallSet passages_without_price() const {
    CellSet north, east;
    const Size size = briefing().size;
    for (int y = 0, index = 0; y < size.height; ++y) {
      std::uint64_t to_north = 0, to_east = 0;
      for (int x = 0; x < size.width; ++x, ++index) {
        to_north |= std::uint64_t{outlook_.prices().north()[index] == 0} << x;
        to_east |= std::uint64_t{outlook_.prices().east()[index] == 0} << x;
      }
      north.set_row(y, to_north);
      east.set_row(y, to_east);
    }
    return passages_of_routes(size, WallSet::of(north, east), briefing().start.cell, briefing().goals);
  }

  DriveTime saving(Cell cell) const {
    const std::optional<OptimisticRun> run = runs_->through(cell);
    const int gain = run ? known_ - run->time - policy_.run_gain : 0;
    if (gain <= 0) return 0;
    // Small gains count less, because they are less certain. The exponent on the probability allows for correlated
    // walls of a route.
    const double trust = std::sqrt(std::sqrt(gain / (policy_.sure_gain * known_)));
    const double worth = weighs() ? policy_.cell_worth / 30 * briefing().drive.maze_time_divisor : policy_.look_worth;
    const double most = (weighs() ? policy_.cell_most : policy_.look_most) * search_.cell;
    const double saved = worth * trust * 1000 * gain * probability(static_cast<int>(policy_.chance * run->price));
    return static_cast<DriveTime>(std::min(most, saved) + policy_.cell_least * search_.cell);
  }

  DrivePolicy policy_;
  SearchDrive search_;
  const WallPrior* prior_;
  Outlook outlook_;
  std::optional<DriveRuns> routes_;
  bool likely_;               ///< considers only walls that are likely enough to be open
  double least_part_;         ///< share of the known time that a possible route has to save; 0: any gain
  RunCosts* runs_ = nullptr;  ///< null in mazes that are too large
  SearchField& ways_;
  std::vector<DriveTime> savings_;
  std::optional<SearchPlace> next_;        ///< where the last step led to, if the plan of the ways still holds there
  int known_ = RunCosts::no_run;           ///< approximate time of the best known run, ms
  std::optional<WallSet> known_passages_;  ///< passages that this run may take
  DriveTime known_time_ = no_time;         ///< exact time; no_time if it is above a limit
  DriveTime known_limit_ = no_time;        ///< of that computation
  std::optional<WallSet> timed_passages_;  ///< passages for which it was computed
  bool news_ = true;
};

}  // namespace

std::unique_ptr<DrivingStrategy> make_driver(const Briefing& briefing, const Settings& settings,
                                             const WallPrior* prior) {
  return std::make_unique<Driver>(briefing, settings, prior);
}

}  // namespace labmouse::ariadne
