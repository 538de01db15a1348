#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/pictures/picture_layers.hpp"
#include "tests/lab/drawing/drawing_samples.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::HasSubstr;

TEST(Layers, AreReadFromTheirNames) {
  EXPECT_EQ(read_layers("path,heat").layers, (LayerSet{Layer::heat, Layer::path}));
  for (const Layer layer : all_layers()) {
    EXPECT_EQ(read_layers(name_of(layer)).layers, LayerSet{layer});
    EXPECT_NE(meaning_of(layer), "");
  }
  EXPECT_EQ(all_layers().size(), 10U);
}

TEST(Layers, AreRefusedWithTheNearestName) {
  EXPECT_THAT(read_layers("heat,pth").error, Says("'pth'", "'path'"));
  EXPECT_THAT(read_layers("heat,").error, Says("layer ''", "heat, path, search, "));
  EXPECT_THAT(read_layers("").error, HasSubstr("layer ''"));
  EXPECT_THAT(read_layers("cells,distances").error, Says("distances and cells", "choose one"));
}

/// A walk through a maze of three by three cells as a record.
RecordFile recorded(std::vector<Action> actions, const Maze& maze = ring()) {
  RecordFile file;
  file.maze = maze;
  file.rules.budget = static_cast<int>(actions.size());
  Script script(maze.size(), std::move(actions));
  file.run = run(maze, file.rules, script);
  return file;
}

/// To the goal in three steps, one step on, one back, the reset, and the same way again.
RecordFile there_and_back() {
  const Action north = Action::step(0, 2), east = Action::step(90, 1), south = Action::step(90, 1);
  return recorded({north, east, south, Action::step(-90, 1), Action::step(0, -1), Action::reset(), north, east, south});
}

const Pose goal = {{1, 1}, Heading::south};

TEST(Layers, OnlyThoseChosenAreMade) {
  const DrawingLayers none = layers_of(there_and_back(), {});
  EXPECT_FALSE(none.coordinates || none.label || none.visits || none.unknown || none.wrong || none.search_run ||
               none.explored);
  EXPECT_TRUE(none.route.empty());
  const DrawingLayers all =
      layers_of(there_and_back(), {Layer::heat, Layer::path, Layer::search_run, Layer::known, Layer::wrong,
                                   Layer::shares, Layer::distances, Layer::coordinates});
  EXPECT_TRUE(all.coordinates && all.label && all.visits && all.unknown && all.wrong && all.search_run && all.explored);
  EXPECT_EQ(all.route, way_to_goal());
}

TEST(Layers, ExplorationIsCutAtTheFirstGoalAndEndsAtTheReset) {
  const SearchLegs legs = *layers_of(there_and_back(), {Layer::search_run}).search_run;
  EXPECT_EQ(legs.to_goal, way_to_goal());
  EXPECT_EQ(legs.onwards, (std::vector<Pose>{goal, {{2, 1}, Heading::east}, {{1, 1}, Heading::east}}));
}

TEST(Layers, ExplorationWithoutGoalOrResetGoesToTheEnd) {
  const Action north = Action::step(0, 2), east = Action::step(90, 1), south = Action::step(90, 1);
  const SearchLegs lost = *layers_of(recorded({north, east}), {Layer::search_run}).search_run;
  EXPECT_EQ(lost.to_goal.back(), (Pose{{1, 2}, Heading::east}));
  EXPECT_TRUE(lost.onwards.empty());
  const SearchLegs stayed = *layers_of(recorded({north, east, south}), {Layer::search_run}).search_run;
  EXPECT_EQ(stayed.onwards, std::vector<Pose>{goal});
  // The reset is the last step: what comes after it is no part of the search run.
  const SearchLegs reset = *layers_of(recorded({north, east, south, Action::reset()}), {Layer::search_run}).search_run;
  EXPECT_EQ(reset.onwards, std::vector<Pose>{goal});
  EXPECT_TRUE(layers_of(recorded({north, east}), {Layer::path}).route.empty());
}

TEST(Layers, WrongGuessesAreTheUnknownWallsThatAreClosed) {
  // At the start the mouse sees the wall beside it and the corridor ahead; from (0,2) the corridor to (1,2).
  const DrawingLayers layers =
      layers_of(recorded({Action::step(0, 2), Action::step(0, 0)}), {Layer::known, Layer::wrong});
  EXPECT_EQ(layers.unknown->count(), 12 - 5);
  WallSet wrong;
  wrong.insert(wall_at({0, 1}, Heading::east));
  wrong.insert(wall_at({1, 1}, Heading::south));
  EXPECT_EQ(layers.wrong, wrong);
}

TEST(Layers, KnowledgeOfTheSpeedRunDoesNotCount) {
  const std::vector<Action> search_run = {Action::step(0, 1), Action::step(90, 1), Action::reset()};
  // The speed run strays into (2,0), where it sees the east.
  std::vector<Action> both = search_run;
  for (const Action& action : {Action::step(90, 2), Action::step(-90, 2)}) both.push_back(action);
  const RecordFile shorter = recorded(search_run, empty({3, 3})), longer = recorded(both, empty({3, 3}));
  EXPECT_EQ(layers_of(longer, {Layer::known}).unknown, layers_of(shorter, {Layer::known}).unknown);
  EXPECT_EQ(longer.run.steps.back().run, Run::speed);
}

/// With a choice in the first step and one in the fourth.
RecordFile reasoned() {
  RecordFile file = there_and_back();
  file.run.reasons = {{1, {}}, {4, {}}};
  return file;
}

TEST(Layers, CandidatesAreThoseOfTheLastChoiceWithTheMouseThere) {
  const DrawingLayers layers = layers_of(reasoned(), {Layer::candidates});
  EXPECT_EQ(layers.candidates->step, 4);
  EXPECT_EQ(layers.mouse, goal);
  EXPECT_FALSE(layers_of(reasoned(), {Layer::heat}).candidates);
  EXPECT_FALSE(layers_of(reasoned(), {Layer::heat}).mouse);
  EXPECT_FALSE(layers_of(there_and_back(), {Layer::candidates}).candidates);
}

TEST(Layers, OfAnEarlierStepShowWhatWasSoThen) {
  const RecordFile third = as_of(reasoned(), 3);
  EXPECT_EQ(layers_of(third, {Layer::candidates}).candidates->step, 1);
  EXPECT_EQ(layers_of(third, {Layer::search_run}).search_run->to_goal, way_to_goal());
  EXPECT_TRUE(layers_of(third, {Layer::path}).route.empty());
  EXPECT_FALSE(third.ended);
  EXPECT_EQ(score(third.run, third.rules).value, std::nullopt);
  EXPECT_EQ(layers_of(as_of(reasoned(), 4), {Layer::candidates}).candidates->step, 4);
}

TEST(Layers, OfTheLastStepAreThoseOfTheRecord) {
  const RecordFile all = as_of(reasoned(), 9);
  EXPECT_EQ(all.run, reasoned().run);
  EXPECT_TRUE(all.ended);
}

TEST(Layers, DistancesAreStepsAndCellsAreCells) {
  const DrawingLayers steps = layers_of(ring(), Rules(), {Layer::distances});
  const DrawingLayers cells = layers_of(ring(), Rules(), {Layer::cells});
  EXPECT_EQ(steps.label({0, 0}), "3");
  EXPECT_EQ(cells.label({0, 0}), "4");
  EXPECT_EQ(steps.label_meaning, "steps to the goal");
  EXPECT_EQ(cells.label_meaning, "cells to the goal");
}

TEST(Layers, PathOfAMazeIsAShortestRun) {
  EXPECT_EQ(layers_of(ring(), Rules(), {Layer::path}).route.size(), 4U);
  EXPECT_TRUE(layers_of(ring(), Rules(), {}).route.empty());
}

}  // namespace
}  // namespace labmouse
