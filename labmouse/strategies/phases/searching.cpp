#include "labmouse/strategies/phases/searching.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "labmouse/strategies/phases/goal_oriented.hpp"
#include "labmouse/strategies/phases/unexplored.hpp"

namespace labmouse {
namespace {

/// Quarter turns of the three ways of a one-step search. It never goes backwards: the heading would not change, so the
/// next step would undo the last one.
constexpr std::array ways = {-1, 0, 1};

Action one_cell(int quarters) { return Action::step(90 * quarters, 1); }
Action turn_in_place() { return Action::step(90, 0); }

bool is_open(const Knowledge& knowledge, Pose pose, int quarters) {
  return knowledge.open().contains(wall_at(pose.cell, turned(pose.heading, quarters)));
}

/// Moves one cell left, ahead or right at random. Methods differ in the weights of the three.
class OneStep : public Searching {
 public:
  explicit OneStep(const Briefing& briefing) : rng_(briefing.seed) {}

  std::optional<Action> next(const Knowledge& knowledge, Pose pose) final {
    std::array<int, ways.size()> weights{};
    int total = 0, open = 0;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (!is_open(knowledge, pose, ways[i])) continue;
      total += weights[i] = weight(knowledge, pose, ways[i]);
      ++open;
    }
    if (open == 0) return turn_in_place();
    if (total > 0) return one_cell(thrown(weights, total));
    // All weights are 0: equal probabilities.
    for (std::size_t i = 0; i < ways.size(); ++i) weights[i] = is_open(knowledge, pose, ways[i]) ? 1 : 0;
    return one_cell(thrown(weights, open));
  }

 protected:
  /// The weight of an open way.
  virtual int weight(const Knowledge& knowledge, Pose pose, int quarters) = 0;

 private:
  int thrown(const std::array<int, ways.size()>& weights, int total) {
    int rest = rng_.below(total);
    for (std::size_t i = 0; i + 1 < ways.size(); ++i) {
      if (rest < weights[i]) return ways[i];
      rest -= weights[i];
    }
    return ways.back();
  }

  Rng rng_;
};

class RandomTurn final : public OneStep {
 public:
  using OneStep::OneStep;

 private:
  int weight(const Knowledge&, Pose, int) override { return 1; }
};

class WeightedTurn final : public OneStep {
 public:
  WeightedTurn(const Briefing& briefing, const Settings& settings) : OneStep(briefing) {
    const std::vector<double> weights = settings.list("weights");
    for (std::size_t i = 0; i < ways.size(); ++i) weights_[i] = static_cast<int>(std::lround(weights[i] * 1000));
  }

 private:
  int weight(const Knowledge&, Pose, int quarters) override { return weights_[static_cast<std::size_t>(quarters + 1)]; }

  std::array<int, ways.size()> weights_{};  // in thousandths
};

/// Prefers unexplored neighbours.
class UnexploredCell final : public OneStep {
 public:
  using OneStep::OneStep;

 private:
  int weight(const Knowledge& knowledge, Pose pose, int quarters) override {
    const Cell cell = neighbour(pose.cell, turned(pose.heading, quarters));
    return unexplored_cells(knowledge).contains(cell) ? 1 : 0;
  }
};

/// Prefers neighbours that lead to much unexplored space: the number of unseen sides of all cells reachable from there
/// without passing the present cell.
class UnexploredSpace final : public OneStep {
 public:
  explicit UnexploredSpace(const Briefing& briefing) : OneStep(briefing), field_(briefing.size, briefing.motion) {}

 private:
  int weight(const Knowledge& knowledge, Pose pose, int quarters) override {
    WallSet passages = knowledge.open();
    for (const Heading side : all_headings)
      if (const Wall wall = wall_at(pose.cell, side); passages.contains(wall)) passages.erase(wall);
    CellSet from;
    from.insert(neighbour(pose.cell, turned(pose.heading, quarters)));
    field_.fill(passages, from);
    int sides = 0;
    knowledge.unknown().for_each([&](Wall wall) {
      sides += (field_.reaches(wall.cell) ? 1 : 0) + (field_.reaches(neighbour(wall.cell, wall.side)) ? 1 : 0);
    });
    return sides;
  }

  DistanceField field_;
};

/// Takes the first open way from the left; in a dead end it turns in place.
class LeftHand final : public Searching {
 public:
  std::optional<Action> next(const Knowledge& knowledge, Pose pose) override {
    for (const int quarters : ways)
      if (is_open(knowledge, pose, quarters)) return one_cell(quarters);
    return turn_in_place();
  }
};

/// Goes to the most promising unexplored cell; if none is left, to a goal, if one is reachable.
class MostPromising final : public Searching {
 public:
  MostPromising(const Briefing& briefing, const Settings& settings)
      : goals_(briefing.goals), walk_(briefing, settings) {}

  std::optional<Action> next(const Knowledge& knowledge, Pose pose) override {
    const auto action = walk_.towards(unexplored_cells(knowledge), knowledge, pose);
    return action ? action : walk_.towards(goals_, knowledge, pose);
  }

 private:
  CellSet goals_;
  GoalOriented walk_;
};

}  // namespace

std::unique_ptr<Searching> make_searching(const Briefing& briefing, const Settings& settings) {
  const std::string_view name = settings.choice("searching");
  if (name == "random") return std::make_unique<RandomTurn>(briefing);
  if (name == "weighted") return std::make_unique<WeightedTurn>(briefing, settings);
  if (name == "unexplored-cell") return std::make_unique<UnexploredCell>(briefing);
  if (name == "unexplored-space") return std::make_unique<UnexploredSpace>(briefing);
  if (name == "wall-follower") return std::make_unique<LeftHand>();
  assert(name == "goal-oriented");
  return std::make_unique<MostPromising>(briefing, settings);
}

bool searches_by_chance(const Settings& settings) {
  const std::string_view name = settings.choice("searching");
  return name != "wall-follower" && name != "goal-oriented";
}

}  // namespace labmouse
