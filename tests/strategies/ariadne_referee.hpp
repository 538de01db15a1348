// Stands between a contest and ariadne, works out each decision anew from its definition, the plain way, and objects to
// what differs.
#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/strategy.hpp"
#include "labmouse/strategies/ariadne/policy.hpp"
#include "tests/mouse/plain_priced_field.hpp"
#include "tests/strategies/plain_outlook.hpp"

namespace labmouse::test {

class AriadneReferee final : public Strategy {
 public:
  /// The briefing asks for reasons.
  AriadneReferee(Strategy& mouse, const Briefing& briefing, const Settings& settings)
      : mouse_(mouse),
        briefing_(briefing),
        policy_(settings),
        outlook_(briefing, settings.choice("prior") == "contest" ? contest_prior_for(briefing.size) : nullptr),
        knowledge_(briefing.size),
        pose_(briefing.start),
        prices_(briefing.size, WallPrices::closed) {}

  Action decide(const Sighting& seen) override {
    const bool news = outlook_.learn(pose_, seen);
    EXPECT_TRUE(knowledge_.learn(pose_, seen));
    const Action action = mouse_.decide(seen);
    look_around();
    if (racing_)
      judge_race(action);
    else
      judge(action, news);
    perform(action);
    return action;
  }
  const Knowledge& knowledge() const override { return knowledge_; }

  /// Whether the mouse went back to the start because nothing was worth its price: not for want of time, and not
  /// because it took the maze for one without loops.
  bool stopped_content() const { return stopped_content_; }
  /// Whether it took the maze for one without loops.
  bool stopped_at_the_goal() const { return stopped_at_the_goal_; }

 private:
  PricedWorld world(PriceOf price) const {
    return {briefing_.size, briefing_.motion, ariadne::step_price, std::move(price)};
  }
  /// Steps over known passages from some cells to each.
  std::vector<int> steps_from(const CellSet& cells) const {
    const auto price = [&](Wall wall) { return knowledge_.open().contains(wall) ? 0 : int{WallPrices::closed}; };
    return plain_costs({briefing_.size, briefing_.motion, 1, price}, cells);
  }
  int of(const std::vector<int>& numbers, Cell cell) const {
    return numbers[static_cast<std::size_t>(briefing_.size.index(cell))];
  }
  int steps_left() const { return briefing_.budget - steps_; }
  bool unknown(Wall wall) const {
    return knowledge_.state(wall) == WallState::unknown && !on_border(wall, briefing_.size);
  }

  void look_around() {
    travel_ = steps_from(CellSet::of(pose_.cell));
    to_goal_ = steps_from(briefing_.goals);
    known_ = of(to_goal_, briefing_.start.cell);
    nearest_goal_ = unreachable;
    briefing_.goals.for_each([&](Cell goal) { nearest_goal_ = std::min(nearest_goal_, of(travel_, goal)); });
  }

  void judge_race(const Action& action) {
    const int before = of(to_goal_, pose_.cell);
    ASSERT_EQ(action.kind, Action::Kind::step);
    ASSERT_TRUE(is_seen_to_be_open(action));
    if (before == 0) {
      ASSERT_EQ(action, Action::step(0, 0));
    }
    ASSERT_EQ(of(to_goal_, after(pose_, action).cell), std::max(0, before - 1));
  }

  void judge(const Action& action, bool news) {
    if (!goal_entered_ && briefing_.goals.contains(pose_.cell)) {
      ASSERT_EQ(action, Action::step(0, 0));
      return;
    }
    const bool just_entered = goal_entered_ && !after_the_goal_;
    if (just_entered && (policy_.loop_free ||
                         (policy_.may_be_loop_free && outlook_.evidence_against_loops() > 64 * (is_large() ? 8 : 1)))) {
      ASSERT_EQ(action, Action::reset());
      ASSERT_NE(mouse_.reasons(), nullptr);
      ASSERT_EQ(mouse_.reasons()->ground, Ground::no_loops);
      ASSERT_EQ(mouse_.reasons()->known, 30 * known_);
      stopped_at_the_goal_ = true;
      return;
    }
    after_the_goal_ = goal_entered_;
    if (!goal_entered_ && (is_large() || in_a_hurry())) {
      judge_flood(action, briefing_.goals);
      return;
    }
    if (is_large()) {
      judge_way_home(action, news || just_entered);
      return;
    }
    const bool chooses = news || just_entered || !target_ || pose_.cell == target_->seen_from;
    ASSERT_EQ(mouse_.reasons() != nullptr, chooses) << "chooses where there is something new, and only there";
    if (chooses) {
      ASSERT_NO_FATAL_FAILURE(judge_choice(*mouse_.reasons()));
    }
    const bool last_call = steps_left() <= std::max(known_, 1) + 1;
    if (goal_entered_ && (!target_ || last_call)) {
      ASSERT_EQ(action, Action::reset());
      stopped_content_ = !target_ && !last_call;
    } else if (!target_) {
      ASSERT_EQ(action, Action::forfeit(ForfeitReason::no_route));
      ASSERT_FALSE(could_reach_a_goal());
    } else {
      ASSERT_NO_FATAL_FAILURE(judge_step(action));
    }
  }

  bool in_a_hurry() const {
    return 8 * briefing_.budget < 7 * briefing_.size.area() || 2 * steps_left() < briefing_.budget;
  }

  bool is_large() const { return briefing_.size.area() > 400; }

  /// After the goal in a large maze: home by a flood as long as any wall is worth a look.
  void judge_way_home(const Action& action, bool chooses) {
    const bool last_call = steps_left() <= std::max(known_, 1) + 1;
    const bool at_start = pose_.cell == briefing_.start.cell;
    if (action.kind != Action::Kind::reset) {
      ASSERT_FALSE(at_start || last_call);
      judge_flood(action, CellSet::of(briefing_.start.cell));
      return;
    }
    if (at_start || last_call) return;
    stopped_content_ = true;
    ASSERT_TRUE(chooses) << "stops where there is something new, and only there";
    ASSERT_NE(mouse_.reasons(), nullptr);
    ASSERT_NO_FATAL_FAILURE(judge_choice(*mouse_.reasons()));
    ASSERT_FALSE(target_);
  }

  /// A step of a flood fill: nearer to the cells by all that could be open, or a turn to look behind.
  void judge_flood(const Action& action, const CellSet& cells) const {
    ASSERT_NE(mouse_.reasons(), nullptr);
    ASSERT_EQ(mouse_.reasons()->ground, Ground::flood);
    ASSERT_TRUE(mouse_.reasons()->candidates.empty());
    if (!goal_entered_ && !could_reach_a_goal()) {
      ASSERT_EQ(action, Action::forfeit(ForfeitReason::no_route));
      return;
    }
    ASSERT_EQ(action.kind, Action::Kind::step);
    ASSERT_TRUE(is_seen_to_be_open(action));
    const auto price = [&](Wall wall) { return knowledge_.possible().contains(wall) ? 0 : int{WallPrices::closed}; };
    const std::vector<int> steps = plain_costs({briefing_.size, briefing_.motion, 1, price}, cells);
    if (action.movement == 0) {
      ASSERT_EQ(action, Action::step(90, 0));
    } else {
      ASSERT_LE(of(steps, after(pose_, action).cell), of(steps, pose_.cell));
    }
  }

  bool could_reach_a_goal() const {
    const auto price = [&](Wall wall) { return knowledge_.possible().contains(wall) ? 0 : int{WallPrices::closed}; };
    const std::vector<int> costs = plain_costs(world(price), briefing_.goals);
    return of(costs, pose_.cell) < unreachable;
  }

  void judge_choice(const Reasons& reasons) {
    ASSERT_EQ(reasons.ground, Ground::candidates);
    const ariadne::Phase& phase = goal_entered_ ? policy_.after : policy_.before;
    prices_ = outlook_.prices(phase.prices);
    WallNumbers through = costs_through(phase);
    bool none = !goal_entered_ && nearest_goal_ == unreachable;
    WallSet::all(briefing_.size).for_each([&](Wall wall) { none = none && !is_candidate(wall, through); });
    if (none) {
      prices_ = outlook_.prices(policy_.last_resort);
      through = costs_through(phase);
    }
    ASSERT_NO_FATAL_FAILURE(judge_candidates(reasons, phase, through));
    ASSERT_NO_FATAL_FAILURE(judge_best(reasons));
    ASSERT_EQ(reasons.known, known_ < unreachable ? 30 * known_ : 0);
  }

  WallNumbers costs_through(const ariadne::Phase& phase) const {
    const PricedWorld priced = world([&](Wall wall) { return prices_[wall]; });
    return plain_costs_through(priced, briefing_.start.cell, briefing_.goals, phase.way_here);
  }

  /// An unseen wall beside a cell that can be reached, through which a run could lead.
  bool is_candidate(Wall wall, const WallNumbers& through) const {
    if (!unknown(wall) || prices_[wall] == WallPrices::closed || through[wall] == unreachable) return false;
    return of(travel_, wall.cell) < unreachable || of(travel_, neighbour(wall.cell, wall.side)) < unreachable;
  }

  void judge_candidates(const Reasons& reasons, const ariadne::Phase& phase, const WallNumbers& through) const {
    WallSet walls;
    int goals = 0;
    for (const Candidate& candidate : reasons.candidates) {
      if (candidate.goal) {
        ++goals;
        ASSERT_NO_FATAL_FAILURE(judge_goal(candidate, phase));
        continue;
      }
      ASSERT_TRUE(is_candidate(candidate.wall, through));
      ASSERT_FALSE(walls.contains(candidate.wall));
      walls.insert(candidate.wall);
      ASSERT_NO_FATAL_FAILURE(judge_wall(candidate, phase, through[candidate.wall]));
    }
    ASSERT_EQ(goals, !goal_entered_ && nearest_goal_ < unreachable ? 1 : 0);
    WallSet::all(briefing_.size).for_each([&](Wall wall) {
      ASSERT_EQ(walls.contains(wall), is_candidate(wall, through));
    });
  }

  void judge_goal(const Candidate& goal, const ariadne::Phase& phase) const {
    ASSERT_TRUE(briefing_.goals.contains(goal.seen_from));
    ASSERT_EQ(goal.travel, nearest_goal_);
    ASSERT_EQ(of(travel_, goal.seen_from), nearest_goal_);
    ASSERT_TRUE(goal.worth);
    const std::int64_t score = std::int64_t{30} * known_ * phase.way_here + std::int64_t{goal.travel} * phase.travel;
    // Of equals it is the goal.
    ASSERT_EQ(goal.score * ariadne::one, static_cast<double>(score - policy_.goal_bonus - 1));
  }

  void judge_wall(const Candidate& wall, const ariadne::Phase& phase, int through) const {
    ASSERT_EQ(wall.through, through);
    ASSERT_EQ(wall.travel, travel_to_look_at(wall.wall));
    ASSERT_TRUE(looks_at(wall.seen_from, wall.wall));
    ASSERT_EQ(of(travel_, wall.seen_from), wall.travel);
    if (goal_entered_) {
      const bool pays = std::int64_t{through} * 256 + std::int64_t{wall.travel} * policy_.stop_travel <
                        std::int64_t{30} * known_ * 256 + policy_.stop_margin;
      ASSERT_EQ(wall.worth, pays);
    } else {
      judge_time(wall);
    }
    const std::int64_t score = std::int64_t{through} * 256 + std::int64_t{wall.travel} * phase.travel -
                               std::int64_t{unseen_from(wall.seen_from)} * phase.insight;
    ASSERT_EQ(wall.score * ariadne::one, static_cast<double>(score));
  }

  /// There, a turn, back, into the goal, the reset and the run.
  void judge_time(const Candidate& wall) const {
    const int needed = 2 * wall.travel + 1 + nearest_goal_ + 1 + std::max(known_, 1);
    ASSERT_EQ(wall.worth, nearest_goal_ == unreachable || needed <= steps_left());
  }

  /// Whether someone in the cell who turns to the wall sees it: all between them is known to be open.
  bool looks_at(Cell cell, Wall wall) const {
    if (wall.side == Heading::north ? cell.x != wall.cell.x : cell.y != wall.cell.y) return false;
    for (const Heading direction : all_headings)
      for (Cell at = cell;; at = neighbour(at, direction)) {
        if (wall_at(at, direction) == wall) return true;
        if (!knowledge_.open().contains(wall_at(at, direction))) break;
      }
    return false;
  }
  int travel_to_look_at(Wall wall) const {
    int nearest = unreachable;
    for (int index = 0; index < briefing_.size.area(); ++index) {
      const Cell cell = briefing_.size.cell_at(index);
      if (of(travel_, cell) < nearest && looks_at(cell, wall)) nearest = of(travel_, cell);
    }
    return nearest;
  }
  int unseen_from(Cell cell) const {
    int unseen = 0;
    WallSet::all(briefing_.size).for_each([&](Wall wall) {
      if (unknown(wall) && prices_[wall] != WallPrices::closed && looks_at(cell, wall)) ++unseen;
    });
    return unseen;
  }

  /// The chosen one has the lowest score of those that are worth it.
  void judge_best(const Reasons& reasons) {
    const Candidate* best = nullptr;
    for (const Candidate& candidate : reasons.candidates)
      if (candidate.worth && (best == nullptr || candidate.score < best->score)) best = &candidate;
    target_.reset();
    if (best == nullptr) {
      ASSERT_EQ(reasons.chosen, -1);
      return;
    }
    ASSERT_GE(reasons.chosen, 0);
    ASSERT_LT(reasons.chosen, static_cast<int>(reasons.candidates.size()));
    target_ = reasons.candidates[static_cast<std::size_t>(reasons.chosen)];
    ASSERT_TRUE(target_->worth);
    ASSERT_EQ(target_->score, best->score);
  }

  bool is_seen_to_be_open(const Action& step) const {
    Pose at = pose_;
    at.heading = rotated(at.heading, step.rotation);
    const Heading direction = step.movement < 0 ? opposite(at.heading) : at.heading;
    for (int cells = std::abs(step.movement); cells > 0; --cells, at.cell = neighbour(at.cell, direction))
      if (!knowledge_.open().contains(wall_at(at.cell, direction))) return false;
    return std::abs(step.movement) <= briefing_.motion.longest;
  }

  /// Of the steps on a shortest known way one that ends beside most unseen walls, and rather not backwards.
  void judge_step(const Action& action) const {
    ASSERT_EQ(action.kind, Action::Kind::step);
    ASSERT_TRUE(is_seen_to_be_open(action));
    if (pose_.cell == target_->seen_from) {
      ASSERT_EQ(action.movement, 0);
      ASSERT_NE(action.rotation, 0);
      return;
    }
    const std::vector<int> way = steps_from(CellSet::of(target_->seen_from));
    const auto value = [&](const Action& step) {
      if (!is_seen_to_be_open(step) || of(way, after(pose_, step).cell) + 1 != of(way, pose_.cell)) return -1;
      int unseen = 0;
      for (const Heading side : all_headings) unseen += unknown(wall_at(after(pose_, step).cell, side)) ? 1 : 0;
      return 2 * unseen + (step.movement > 0 ? 1 : 0);
    };
    int most = -1;
    for (int cells = 1; cells <= briefing_.motion.longest; ++cells)
      for (const Heading direction : all_headings)
        most = std::max(most, value(move_in(pose_.heading, direction, cells)));
    ASSERT_GE(most, 0);
    ASSERT_EQ(value(action), most);
  }

  void perform(const Action& action) {
    ++steps_;
    if (action.kind == Action::Kind::reset) {
      racing_ = true;
      pose_ = briefing_.start;
    }
    if (action.kind != Action::Kind::step) return;
    pose_ = after(pose_, action);
    goal_entered_ = goal_entered_ || briefing_.goals.contains(pose_.cell);
  }

  Strategy& mouse_;
  Briefing briefing_;
  ariadne::Policy policy_;
  PlainOutlook outlook_;
  Knowledge knowledge_;
  Pose pose_;
  int steps_ = 0;
  bool goal_entered_ = false, after_the_goal_ = false, racing_ = false;
  bool stopped_content_ = false, stopped_at_the_goal_ = false;
  std::vector<int> travel_, to_goal_;
  int known_ = unreachable, nearest_goal_ = unreachable;
  WallNumbers prices_;
  std::optional<Candidate> target_;
};

}  // namespace labmouse::test
