#include "tests/contest/plain_simulator.hpp"

#include <gtest/gtest.h>

#include <climits>
#include <map>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

/// A maze of any generator and small size (so that chance finds goals), with start and goals anywhere.
Maze random_maze(Rng& rng) {
  for (;;) {
    const auto generators = all_generators();
    const Generator& generator = *generators[static_cast<std::size_t>(rng.below(static_cast<int>(generators.size())))];
    const GeneratorOrder order{{1 + rng.below(9), 1 + rng.below(9)}, rng.bits(), rng.below(1001)};
    if (!generator.refuses(order).empty()) continue;
    CellSet goals;
    for (int goal = 0, count = 1 + rng.below(4); goal < count; ++goal)
      goals.insert(order.size.cell_at(rng.below(order.size.area())));
    return generator.make(order)
        .with_start(order.size.cell_at(rng.below(order.size.area())),
                    all_headings[static_cast<std::size_t>(rng.below(4))])
        .with_goals(goals);
  }
}

/// Mostly what a mouse would do, often what none should.
Action random_action(Rng& rng) {
  if (rng.chance(1, 40)) return Action::reset();
  if (rng.chance(1, 4000)) return Action::forfeit(ForfeitReason::lost);
  constexpr int nonsense[] = {1, -1, 45, 89, 91, 180, -180, 270, 360, INT_MAX, INT_MIN};
  const int rotation = rng.chance(1, 10) ? nonsense[rng.below(std::size(nonsense))] : 90 * (rng.below(3) - 1);
  const int movement = rng.chance(1, 10) ? nonsense[rng.below(std::size(nonsense))] : rng.below(11) - 5;
  return Action::step(rotation, movement);
}

::testing::AssertionResult agree(const RunRecord& record, const test::PlainContest& plain) {
  if (record.steps.size() != plain.steps.size())
    return ::testing::AssertionFailure() << record.steps.size() << " steps, plainly " << plain.steps.size();
  for (std::size_t i = 0; i < record.steps.size(); ++i) {
    const StepRecord& fast = record.steps[i];
    const test::PlainStep& step = plain.steps[i];
    if (fast.step != step.clock || (fast.run == Run::speed) != step.speed_run ||
        fast.pose.cell != Cell(step.x, step.y) || name_of(fast.pose.heading)[0] != step.heading ||
        fast.sighting != Sighting{step.left, step.ahead, step.right} || fast.blocked != step.blocked)
      return ::testing::AssertionFailure() << "step " << i + 1 << " differs";
  }
  if (name_of(record.outcome) != plain.outcome)
    return ::testing::AssertionFailure() << name_of(record.outcome) << ", plainly " << plain.outcome;
  if (record.end.cell != Cell(plain.x, plain.y) || name_of(record.end.heading)[0] != plain.heading)
    return ::testing::AssertionFailure() << "they end at different places";
  return ::testing::AssertionSuccess();
}

TEST(PlainSimulator, AgreesStepForStepOverAHundredThousandSteps) {
  Rng rng(20240214);
  std::map<Outcome, int> outcomes;
  for (std::size_t steps = 0; steps < 100'000;) {
    const Maze maze = random_maze(rng);
    Rules rules;
    rules.budget = rng.chance(1, 3) ? 1000 : 1 + rng.below(100);
    rules.stride = rng.chance(1, 2) ? 3 : 1 + rng.below(Motion::max_longest);
    std::vector<Action> actions;
    for (int i = 0; i <= rules.budget; ++i) actions.push_back(random_action(rng));
    Script mouse(maze.size(), actions);
    const RunRecord record = run(maze, rules, mouse);
    ASSERT_TRUE(agree(record, test::PlainSimulator(maze, rules.budget, rules.stride).play(actions)))
        << *drawing_format.write(maze.with_start(maze.start(), Heading::north)).content;
    steps += record.steps.size();
    ++outcomes[record.outcome];
  }
  for (const Outcome outcome : {Outcome::finished, Outcome::out_of_steps, Outcome::never_reset,
                                Outcome::speed_run_unfinished, Outcome::forfeit})
    EXPECT_GE(outcomes[outcome], 10) << "too few contests end with: " << name_of(outcome);
}

}  // namespace
}  // namespace labmouse
