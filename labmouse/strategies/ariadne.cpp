// ariadne: looks at the walls through which a good run could lead, and stops when none is worth the way to it.
//
//   S(e)    = T(e) + travel * d(e) - insight * u(e)              of an unseen wall e
//   S(goal) = way_here * K + travel * d(goal) - goal_bonus       until it was entered
//   The mouse goes to the lowest S. Once the goal was entered, only walls with
//   T(e) + stop_travel * d(e) < K + stop_margin  count.
//
// T(e) is the cost of the cheapest run through e (EdgeCosts), K that of the shortest known run, d the steps to where e
// is seen or the goal is entered, and u the number of unseen walls seen from there. The other names are parameters;
// those of Phase have other values after the goal. In seconds: ariadne/driver.hpp.
//
// Limits: it considers one wall at a time, and ignores what a look is worth for later ones. Its prior is that of
// contest mazes.
#include <algorithm>
#include <optional>

#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/priors.hpp"
#include "labmouse/strategies/ariadne/driver.hpp"
#include "labmouse/strategies/ariadne/edge_costs.hpp"
#include "labmouse/strategies/ariadne/views.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

constexpr std::string_view ariadne_method =
    "Every unseen wall has a price that depends on how likely it is to be closed; that likelihood was counted in other "
    "mazes for each state of its eight neighbours (`labmouse learn`). With these prices, T(e) is the cheapest run from "
    "start to goal through the unseen wall e. Before the goal has been entered, only what lies ahead counts: the mouse "
    "goes to look at the wall with the lowest sum of T(e) and the price of the way there, until the goal itself is the "
    "best choice. Afterwards a wall is worth a look as long as T(e), plus something for the way, is less than the cost "
    "of the shortest known run. When no wall is, the mouse resets at once, wherever it stands. It decides again "
    "whenever it has seen something new. If the walls seen so far look like those of a maze without loops, it stops at "
    "the goal: there is no second route. In mazes of more than 900 cells it floods to the goal and back towards the "
    "start, and only decides by these prices when to stop.";

constexpr std::string_view ariadne_source = "Our own.";

using ariadne::EdgeCosts;
using ariadne::one;
using ariadne::Outlook;
using ariadne::Phase;
using ariadne::Policy;
using ariadne::Views;

class Ariadne final : public Explorer {
 public:
  Ariadne(const Briefing& briefing, const Settings& settings, const WallPrior* prior)
      : Explorer(briefing),
        policy_(settings),
        outlook_(briefing, prior),
        costs_(this->briefing()),
        views_(this->briefing(), knowledge()),
        way_(briefing.size, briefing.motion),
        is_large_(briefing.size.area() > ariadne::largest_to_weigh),
        keeps_reasons_(briefing.reasons) {
    outlook_.price(policy_.before.prices);
    if (keeps_reasons_) reasons_.candidates.reserve(static_cast<std::size_t>(2 * briefing.size.area()));
  }

  const Reasons* reasons() const override { return keeps_reasons_ && chose_ ? &reasons_ : nullptr; }

 private:
  /// Unseen walls that one cell can show.
  static constexpr int most_insights = 4;

  Action explore() override {
    chose_ = false;
    const bool news = outlook_.learn(pose(), seen());
    // The start is a goal: it counts as entered only when a step ends there.
    if (!goal_entered() && briefing().goals.contains(pose().cell)) return Action::step(0, 0);
    const bool just_entered = goal_entered() && phase_ == &policy_.before;
    if (just_entered) {
      if (stops_at_the_goal()) {
        find_known_run();
        give_ground(Ground::no_loops);
        return Action::reset();
      }
      phase_ = &policy_.after;
      outlook_.price(phase_->prices);
    }
    if (!goal_entered() && (is_large_ || in_a_hurry())) return flood_to(briefing().goals);
    if (news || just_entered || !target_ || pose().cell == target_->seen_from) choose();
    if (goal_entered() && (!target_ || last_call())) return Action::reset();
    if (goal_entered() && is_large_) return flood_home();
    return target_ ? go() : Action::forfeit(ForfeitReason::no_route);
  }

  Action race() override {
    chose_ = false;
    return Explorer::race();
  }

  /// Whether the walls seen clearly indicate a maze without loops: odds of e^2, and e^16 in large mazes. A prior
  /// learned from few large mazes is slightly wrong for each of many walls.
  bool stops_at_the_goal() const {
    const int clearly = 2 * 32 * (is_large_ ? 8 : 1);
    return policy_.loop_free || (policy_.may_be_loop_free && outlook_.evidence_against_loops() > clearly);
  }

  /// Whether the budget is small for this maze, or half of it is used before the goal. Then it floods, which finds most
  /// goals in time.
  bool in_a_hurry() const {
    return 8 * briefing().budget < 7 * briefing().size.area() || 2 * steps_left() < briefing().budget;
  }

  Action flood_to(const CellSet& cells) {
    give_ground(Ground::flood);
    way_.fill(knowledge().possible(), cells);
    return optimistic_step(way_);
  }

  Action flood_home() {
    const Cell start = briefing().start.cell;
    return pose().cell == start ? Action::reset() : flood_to(CellSet::of(start));
  }

  /// Whether the reset and the known run only just fit into the budget, or not any more. Here and below, costs are used
  /// as steps; this is on the safe side if moves cost more than one.
  bool last_call() const { return steps_left() <= 1 + known_run(); }

  /// Steps of the shortest known speed run: at least one, even if the start is a goal.
  int known_run() const { return std::max(known_, 1); }

  /// Records the kind of the decision, and clears the candidates.
  void give_ground(Ground ground) {
    chose_ = true;
    reasons_.ground = ground;
    reasons_.candidates.clear();
    reasons_.chosen = -1;
    reasons_.known = known_ < unreachable ? known_ * ariadne::step_price : 0;
    reasons_.hope = reasons_.price = 0;
  }

  void find_known_run() {
    way_.fill(knowledge().open(), briefing().goals);
    known_ = way_.at(briefing().start.cell);
  }

  void choose() {
    target_.reset();
    views_.plan(pose().cell);
    nearest_goal_ = views_.nearest_goal();
    find_known_run();
    give_ground(Ground::candidates);
    if (goal_entered())
      choose_after();
    else
      choose_before();
    if (target_) way_.fill(knowledge().open(), CellSet::of(target_->seen_from));
    if (keeps_reasons_) conclude();
  }

  /// Before the goal has been entered: the best wall, or the goal.
  void choose_before() {
    // First tries only walls about as cheap as the last choice, to save time.
    const bool near =
        !keeps_reasons_ && score_ > 0 && choose_near(static_cast<int>(score_ / one) + ariadne::step_price);
    if (near) return;
    costs_.plan(outlook_.prices(), phase_->way_here);
    consider_all();
    if (!target_) choose_as_last_resort();
  }

  /// Chooses among the runs through cells within a limit of the goal. True where all others would score worse.
  bool choose_near(int limit) {
    costs_.plan_near(limit, outlook_.prices(), phase_->way_here);
    consider_all();
    if (target_ && score_ + judged(most_insights, phase_->insight) < judged(limit + ariadne::step_price, one))
      return true;
    target_.reset();
    return false;
  }

  /// Chooses again with no wall counted as closed, because otherwise no candidate is left.
  void choose_as_last_resort() {
    if (policy_.last_resort == policy_.before.prices) return;
    outlook_.price(policy_.last_resort);
    costs_.plan(outlook_.prices(), phase_->way_here);
    consider_walls();
    outlook_.price(phase_->prices);
  }

  /// After the goal: the best of the walls that are worth a look, if there is one.
  void choose_after() {
    // Only runs better than the known one are computed, unless reasons are recorded.
    if (keeps_reasons_)
      costs_.plan(outlook_.prices(), phase_->way_here);
    else
      costs_.plan_below(known_ * ariadne::step_price + policy_.stop_margin / one + 1, outlook_.prices());
    consider_walls();
  }

  void consider_walls() {
    views_.for_each_unseen([&](Wall wall) { consider_wall(wall); });
  }

  void consider_all() {
    consider_walls();
    consider_goal();
  }

  void consider_wall(Wall wall) {
    if (!outlook_.prices().passable(wall)) return;
    Candidate candidate;
    candidate.wall = wall;
    candidate.through = costs_.through(wall);
    if (candidate.through >= unreachable) return;
    take(candidate, views_.viewpoint(wall));
    candidate.worth = goal_entered() ? pays(candidate) : leaves_time_for_the_goal(candidate);
    const std::int64_t score = judged(candidate.through, one) + judged(candidate.travel, phase_->travel);
    add(candidate, score);
  }

  void consider_goal() {
    if (!nearest_goal_) return;
    Candidate candidate;
    candidate.goal = true;
    take(candidate, *nearest_goal_);
    candidate.through = known_ * ariadne::step_price;
    const std::int64_t score = judged(candidate.through, phase_->way_here) + judged(candidate.travel, phase_->travel);
    // The goal wins ties.
    add(candidate, score - policy_.goal_bonus - 1);
  }

  static void take(Candidate& candidate, const ariadne::Viewpoint& viewpoint) {
    candidate.seen_from = viewpoint.cell;
    candidate.travel = viewpoint.travel;
  }

  /// Weighted cost.
  static std::int64_t judged(int cost, int weight) { return static_cast<std::int64_t>(cost) * weight; }

  bool pays(const Candidate& wall) const {
    return judged(wall.through, one) + judged(wall.travel, policy_.stop_travel) <
           judged(known_ * ariadne::step_price, one) + policy_.stop_margin;
  }

  /// Whether the budget suffices to go there, turn, come back, enter the goal, and run.
  bool leaves_time_for_the_goal(const Candidate& wall) const {
    return !nearest_goal_ || 2 * wall.travel + 1 + nearest_goal_->travel + 1 + known_run() <= steps_left();
  }

  void add(Candidate candidate, std::int64_t score) {
    // Skips the count of visible walls if even the largest bonus would not make this candidate the best.
    const bool near = !target_ || score - judged(most_insights, phase_->insight) < score_;
    if (!candidate.goal && (near || keeps_reasons_))
      score -= judged(views_.unseen_from(candidate.seen_from, outlook_.prices()), phase_->insight);
    candidate.score = static_cast<double>(score) / one;
    if (candidate.worth && (!target_ || score < score_)) {
      target_ = candidate;
      score_ = score;
      reasons_.chosen = static_cast<int>(reasons_.candidates.size());
    }
    if (keeps_reasons_) reasons_.candidates.push_back(candidate);
  }

  /// Completes the reasons: the best run considered after the goal, and the price of the way to it.
  void conclude() {
    if (!target_) reasons_.chosen = -1;
    reasons_.way_here = static_cast<double>(phase_->way_here) / one;
    if (!goal_entered()) return;
    double least = 0;
    for (const Candidate& candidate : reasons_.candidates) {
      const double price = static_cast<double>(judged(candidate.travel, policy_.stop_travel)) / one;
      if (reasons_.hope != 0 && candidate.through + price >= least) continue;
      least = candidate.through + price;
      reasons_.hope = candidate.through;
      reasons_.price = price;
    }
  }

  /// The next step of a shortest known way to the target; ties go to the step that ends beside most unseen walls, then
  /// to one that does not go backwards. At the viewpoint with the wall behind the mouse, a turn.
  Action go() const {
    if (pose().cell == target_->seen_from) return Action::step(90, 0);
    const Motion& motion = briefing().motion;
    Action best = Action::forfeit(ForfeitReason::lost);
    int most = -1;
    for (const int quarters : {0, -1, 1, 2}) {
      const Heading direction = turned(pose().heading, quarters);
      Cell cell = pose().cell;
      for (int cells = 1; cells <= motion.longest && knowledge().open().contains(wall_at(cell, direction)); ++cells) {
        cell = neighbour(cell, direction);
        if (way_.at(cell) + motion.cost[static_cast<unsigned>(cells)] != way_.at(pose().cell)) continue;
        int value = quarters == 2 ? 0 : 1;
        for (const Heading side : all_headings)
          value += knowledge().state(wall_at(cell, side)) == WallState::unknown ? 2 : 0;
        if (value <= most) continue;
        most = value;
        best = move_in(pose().heading, direction, cells);
      }
    }
    return best;
  }

  Policy policy_;
  const Phase* phase_ = &policy_.before;
  Outlook outlook_;
  EdgeCosts costs_;
  Views views_;
  DistanceField way_;  ///< distances to the target over known passages; in floods, over possible ones
  bool is_large_;
  std::optional<ariadne::Viewpoint> nearest_goal_;
  int known_ = unreachable;  ///< length of the shortest known run from start to goal
  std::optional<Candidate> target_;
  std::int64_t score_ = 0;
  Reasons reasons_;
  bool keeps_reasons_;
  bool chose_ = false;
};

/// The prior of the settings. An attached one is used at every size.
const WallPrior* prior_for(const Briefing& briefing, const Settings& settings) {
  const WallPrior* learned = settings.attached();
  return learned == nullptr && settings.choice("prior") == "contest" ? contest_prior_for(briefing.size) : learned;
}

std::unique_ptr<Strategy> make_ariadne(const Briefing& briefing, const Settings& settings) {
  return std::make_unique<Ariadne>(briefing, settings, prior_for(briefing, settings));
}

std::unique_ptr<DrivingStrategy> drive_ariadne(const Briefing& briefing, const Settings& settings) {
  return ariadne::make_driver(briefing, settings, prior_for(briefing, settings));
}

}  // namespace

constinit const BuiltinMouse ariadne_mouse = {
    .name = "ariadne",
    .summary = "looks at walls that a good run could pass, judging by what contest mazes are like",
    .method = ariadne_method,
    .source = ariadne_source,
    .parameters = ariadne::fast_parameters,
    .make = make_ariadne,
    .drive = factory_in_seconds(drive_ariadne),
};

constinit const BuiltinMouse ariadne_deep_mouse = {
    .name = "ariadne-deep",
    .summary = "the same, but on the way to the goal it also considers the way back",
    .method = ariadne_method,
    .source = ariadne_source,
    .parameters = ariadne::deep_parameters,
    .make = make_ariadne,
};

}  // namespace labmouse
