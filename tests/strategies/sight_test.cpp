// Short-sighted mice: a reading as far as their sight shows no wall at its end.
#include <gtest/gtest.h>

#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/strategies/ariadne/outlook.hpp"
#include "labmouse/strategies/ariadne/views.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

using ariadne::Outlook;

/// A corridor of six cells; the mouse stands in its western end and looks eastwards.
Briefing corridor(int sight) {
  Briefing briefing;
  briefing.size = {6, 1};
  briefing.start = {{0, 0}, Heading::east};
  briefing.goals.insert({5, 0});
  briefing.motion = strides(1);
  briefing.sight = sight;
  return briefing;
}

Wall east_of(int x) { return wall_at({x, 0}, Heading::east); }

TEST(Sight, EndsWhatAnOutlookLearns) {
  const Briefing briefing = corridor(2);
  Outlook outlook(briefing, nullptr);
  ASSERT_TRUE(outlook.learn(briefing.start, {0, 2, 0}));
  EXPECT_TRUE(outlook.prices().passable(east_of(0)));
  EXPECT_TRUE(outlook.prices().passable(east_of(2)));
  ASSERT_TRUE(outlook.learn({{2, 0}, Heading::east}, {0, 0, 0}));
  EXPECT_FALSE(outlook.prices().passable(east_of(2)));
}

TEST(Sight, EndsWhereAWallIsSeenFrom) {
  for (const int sight : {1, 2, 3}) {
    const Briefing briefing = corridor(sight);
    Knowledge knowledge(briefing.size, sight);
    // The four cells in the west are known to be connected, and nothing of the wall behind them.
    for (int x = 0; x + sight <= 3; ++x) ASSERT_TRUE(knowledge.learn({{x, 0}, Heading::east}, {0, sight, 0}));
    ariadne::Views views(briefing, knowledge);
    views.plan({0, 0});
    EXPECT_EQ(views.viewpoint(east_of(3)).cell, (Cell{4 - sight, 0})) << "sight " << sight;
  }
}

TEST(Sight, LetsSomeMiceStepForwardUntilTheySee) {
  for (const char* name : {"flood", "flood-return", "certify", "ariadne"}) {
    const Briefing briefing = corridor(1);
    const auto mouse = find_mouse(name)->make(briefing, Settings(find_mouse(name)->parameters));
    for (int x = 0; x < 5; ++x) EXPECT_EQ(mouse->decide({0, 1, 0}), Action::step(0, 1)) << name << " in " << x;
  }
}

}  // namespace
}  // namespace labmouse
