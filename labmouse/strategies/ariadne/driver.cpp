#include "labmouse/strategies/ariadne/driver.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "labmouse/mouse/drive/drive_fields.hpp"
#include "labmouse/mouse/drive/run_prices.hpp"
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/runs.hpp"
#include "labmouse/mouse/ways.hpp"
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
// Found on 257 contest mazes by CMA-ES, all at once, for the mean of three robots (`classic`, `kerise`, `beginner`)
// under `thirtieth`, November 2026, but for those of looks, which were tried one by one; docs/solver.md says what each
// is worth. Times of a search are in its cells.

/// To the goal, no turn takes longer than this part of a cell: corners show more of a maze. Where the time in the maze
/// does not count, after this part of the time allowed it matters more to arrive.
constexpr double most_for_a_turn = 0.62;
constexpr int part_for_corners = 6;

/// How the ways home are counted.
constexpr double home_turn = 1.33, home_back = 0.7;
constexpr double home_cells_a_nat = 2.77, home_cells_a_wall = 0.04;
constexpr int home_closed = 61;  ///< a wall of that price or more (P(open) < 0.15) is taken for closed

/// How runs are hoped for.
constexpr RunTolls hope_of_runs = {128, 5, 125};
constexpr double longest_run = 1.12;  ///< of the best known one
constexpr int least_gain = 37;        ///< milliseconds

/// What an unseen cell is worth, at most and at least; and where time in the maze does not count, at most.
constexpr double most_for_a_cell = 0.76, least_for_a_cell = 0.017, most_for_a_look = 0.6;
/// What a millisecond of the gain is worth in a search, by the divisor of the rules; and where there is none.
constexpr double worth_by_divisor = 0.94 / 30, worth_of_a_look = 4.7;

/// To a look, so many units of price are worth a cell, in mazes as small as those that the prior was made for.
constexpr int prices_a_cell = 40;
/// In larger ones, entering an unseen cell on the way to a look saves this part of a cell: it will be asked for sooner
/// or later, unless the time ends before.
constexpr double worth_of_news = 0.4;
/// Walls that are rather closed than open (P(open) < 0.46) are no hope for a route, in mazes as small as those that the
/// prior was made for: there are runs (RunCosts).
constexpr int no_hope = 25;
/// A route is a reason to look if it saves so much of the known one; counted is what it saves times P^(trust / 32). And
/// one through unlikely walls, if it saves so much.
constexpr double little_part = 0.017, great_part = 0.3;
constexpr int trust_of_hope = 4;

/// exp(-n / 32), the same on every platform.
double probability(int reluctance) {
  double probability = 1.0;
  for (; reluctance > 0; --reluctance) probability *= 0.96923323447634413;
  return probability;
}

DriveTime part(double factor, DriveTime time) { return static_cast<DriveTime>(factor * time); }

/// With the fields of the briefing, where its maze has room for corridors.
RunPrices run_prices(const Briefing& briefing) {
  if (std::min(briefing.size.width, briefing.size.height) >= run_prices_side)
    return run_prices_of(briefing.drive.fields->routes());
  FastestRoutes routes({run_prices_side, run_prices_side}, route_tables_of(*briefing.drive.model));
  return run_prices_of(routes);
}

class Driver final : public Explorer {
 public:
  Driver(const Briefing& briefing, const WallPrior* prior)
      : Explorer(briefing),
        search_(briefing.drive.model->search),
        prior_(prior),
        outlook_(this->briefing(), prior),
        routes_(std::in_place, this->briefing()),
        likely_(briefing.size.area() <= RunCosts::largest_area),
        least_part_(likely_ ? little_part : 0),
        ways_(this->briefing().drive.fields->ways()),
        savings_(static_cast<std::size_t>(briefing.size.area()), part(worth_of_news, search_.cell)) {
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
      known_time_.reset();
      runs_ != nullptr ? save() : forget_known_cells();
    }
    // Without a run that is known there is nothing to weigh.
    return weighs() && knows_run() ? home() : look();
  }

  /// Expects and hopes anew.
  void renew() override {
    outlook_ = Outlook(briefing(), prior_);
    outlook_.price(reluctances);
    routes_->forget();
    news_ = true;
  }

  bool knows_run() { return runs_ != nullptr ? known_ != RunCosts::no_run : known_time() != no_time; }

  /// Of the fastest known route.
  DriveTime known_time() {
    if (!known_time_) known_time_ = routes_->known_time(knowledge());
    return *known_time_;
  }

  /// Whether the time in the maze counts, so that it has something to weigh.
  bool weighs() const { return briefing().drive.maze_time_divisor > 0; }

  bool is_early() const {
    const std::int64_t limit = briefing().drive.time_limit;
    return part_for_corners * (limit - time_left()) < limit;
  }

  Action to_goal() {
    count_plan();
    SearchTolls tolls{search_};
    if (weighs() || is_early()) tolls.drive.turn = std::min(search_.turn, part(most_for_a_turn, search_.cell));
    return step_towards(briefing().goals, tolls);
  }

  Action home() {
    if (pose().cell == briefing().start.cell) return Action::reset();
    SearchTolls tolls{search_};
    tolls.drive.turn = part(home_turn, search_.turn);
    tolls.drive.back = part(home_back, search_.back);
    tolls.unit = part(home_cells_a_nat / 32, search_.cell);
    tolls.base = part(home_cells_a_wall, search_.cell);
    tolls.closed = home_closed;
    if (runs_ != nullptr) tolls.savings = savings_;
    return step_towards(CellSet::of(briefing().start.cell), tolls);
  }

  /// To where the next unseen wall of the best route that it hopes for can be seen, as certify does.
  Action look() {
    if (routes_->plan(hope(), knowledge().open())) count_plan();
    if (enough() && likely_) hope_for_all();
    if (enough()) return Action::reset();
    const CellSet viewpoints = viewpoints_of(routes_->unknown_walls(), knowledge(), briefing().sight);
    // Standing where the wall could be seen and not seeing it: it is behind.
    if (viewpoints.contains(pose().cell)) return Action::step(90, 0);
    SearchTolls tolls{search_};
    if (runs_ != nullptr) tolls.unit = search_.cell / prices_a_cell;
    if (runs_ != nullptr || has_time_for_all()) tolls.savings = savings_;
    return step_towards(viewpoints, tolls);
  }

  /// Whether the best route that it hopes for is known, or saves little where it exists.
  bool enough() {
    if (routes_->proven()) return true;
    if (least_part_ == 0 || !knows_run()) return false;
    int reluctance = 0;
    routes_->unknown_walls().for_each([&](Wall wall) { reluctance += outlook_.prices().of(wall); });
    const double trust = likely_ ? probability(reluctance * trust_of_hope / 32) : 1;
    return known_time() != no_time && trust * (known_time() - routes_->hoped_time()) < least_part_ * known_time();
  }

  /// This may be a maze in which unlikely walls are open. From now on it looks for great gains alone.
  void hope_for_all() {
    likely_ = false;
    least_part_ = great_part;
    routes_.emplace(briefing());
    routes_->plan(hope(), knowledge().open());
    count_plan();
  }

  /// Passages that it hopes for: all that may be open, or those that are likely enough.
  WallSet hope() const {
    WallSet walls = knowledge().possible();
    if (!likely_) return walls;
    knowledge().unknown().for_each([&](Wall wall) {
      if (outlook_.prices().of(wall) >= no_hope) walls.erase(wall);
    });
    return walls;
  }

  Action step_towards(const CellSet& cells, const SearchTolls& tolls) {
    const SearchPlace here = place();
    ways_.fill(outlook_.prices(), tolls, knowledge().known_cells(), cells, &here);
    return hopeful_step(ways_, knowledge(), here);
  }

  /// Whether the mouse could enter each cell in the time allowed.
  bool has_time_for_all() const {
    return static_cast<std::int64_t>(briefing().size.area()) * search_.cell <= briefing().drive.time_limit;
  }

  /// Known cells show nothing new.
  void forget_known_cells() {
    knowledge().known_cells().for_each(
        [&](Cell cell) { savings_[static_cast<std::size_t>(briefing().size.index(cell))] = 0; });
  }

  /// Finds what entering each unseen cell is worth: what the best run through it would gain, by the chance that it
  /// exists.
  void save() {
    count_plan();
    known_ = runs_->known(outlook_.prices());
    const bool any = known_ == RunCosts::no_run;
    runs_->plan(outlook_.prices(), hope_of_runs, any ? RunCosts::no_run : static_cast<int>(longest_run * known_));
    CellSet::all(briefing().size).for_each([&](Cell cell) {
      savings_[static_cast<std::size_t>(briefing().size.index(cell))] = knowledge().knows(cell) ? 0 : saving(cell);
    });
  }

  DriveTime saving(Cell cell) const {
    const std::optional<HopedRun> run = runs_->through(cell);
    const int gain = run ? known_ - run->time - least_gain : 0;
    if (gain <= 0) return 0;
    // Great gains are surer than small ones to be gains at all; and of the walls of a route some are open together.
    const double trust = std::sqrt(std::sqrt(gain / (0.1 * known_)));
    const double worth = weighs() ? worth_by_divisor * briefing().drive.maze_time_divisor : worth_of_a_look;
    const double most = (weighs() ? most_for_a_cell : most_for_a_look) * search_.cell;
    const double saved = worth * trust * 1000 * gain * probability(run->price * 16 / 25);
    return static_cast<DriveTime>(std::min(most, saved) + least_for_a_cell * search_.cell);
  }

  SearchDrive search_;
  const WallPrior* prior_;
  Outlook outlook_;
  std::optional<DriveRuns> routes_;
  bool likely_;               ///< hopes only for walls that are likely enough
  double least_part_;         ///< of the known route's time that a hoped-for one has to save; 0: anything
  RunCosts* runs_ = nullptr;  ///< where the maze has them
  SearchField& ways_;
  std::vector<DriveTime> savings_;
  int known_ = RunCosts::no_run;         ///< the best known run, about
  std::optional<DriveTime> known_time_;  ///< the same exactly, once it was asked for
  bool news_ = true;
};

}  // namespace

std::unique_ptr<Strategy> make_driver(const Briefing& briefing, const WallPrior* prior) {
  return std::make_unique<Driver>(briefing, prior);
}

}  // namespace labmouse::ariadne
