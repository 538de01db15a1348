#include "labmouse/mouse/forwarding_strategy.hpp"

#include <gmock/gmock.h>

namespace labmouse {
namespace {

using testing::Ref;
using testing::Return;
using testing::ReturnRef;

/// What all strategies have.
template <class Kind>
class Asked : public Kind {
 public:
  MOCK_METHOD(Action, decide, (const Sighting&), (override));
  MOCK_METHOD(const Knowledge&, knowledge, (), (const, override));
  MOCK_METHOD(StrategyReport, report, (), (override));
  MOCK_METHOD(const Reasons*, reasons, (), (const, override));
};

class AskedDriver : public Asked<DrivingStrategy> {
 public:
  MOCK_METHOD(Action, consider, (const LogOddsMap&, const SearchPlace&, std::int64_t), (override));
  MOCK_METHOD(void, show, (const Pose&, const Sighting&), (override));
  MOCK_METHOD(void, carried, (std::int64_t), (override));
  MOCK_METHOD(double, pace, (bool), (override));
  MOCK_METHOD(void, searches_at, (double), (override));
  MOCK_METHOD(std::optional<MapKind>, map_kind, (), (const, override));
  MOCK_METHOD(std::int64_t, plans, (), (const, override));
};

template <class Mock>
void expect_forwarded(Mock& asked, Strategy& forwarding) {
  const Sighting seen{1, 2, 3};
  const Knowledge knowledge({4, 4});
  const Reasons reasons;
  EXPECT_CALL(asked, decide(seen)).WillOnce(Return(Action::step(90, 2)));
  EXPECT_CALL(asked, knowledge).WillOnce(ReturnRef(knowledge));
  EXPECT_CALL(asked, report).WillOnce(Return(StrategyReport{.last_words = "lost"}));
  EXPECT_CALL(asked, reasons).WillOnce(Return(&reasons));
  EXPECT_EQ(forwarding.decide(seen), Action::step(90, 2));
  EXPECT_EQ(&forwarding.knowledge(), &knowledge);
  EXPECT_EQ(forwarding.report().last_words, "lost");
  EXPECT_EQ(forwarding.reasons(), &reasons);
}

TEST(ForwardingStrategy, ForwardsEveryCall) {
  testing::StrictMock<Asked<Strategy>> asked;
  ForwardingStrategy forwarding(asked);
  expect_forwarded(asked, forwarding);
}

TEST(ForwardingDriver, ForwardsEveryCall) {
  testing::StrictMock<AskedDriver> asked;
  ForwardingDriver forwarding(asked);
  expect_forwarded(asked, forwarding);
  DrivingStrategy& driver = forwarding;
  const LogOddsMap map({4, 4}, MapKind::log_odds);
  const SearchPlace place{{{1, 2}, Heading::east}, true};
  const Sighting seen{1, 0, 1};
  EXPECT_CALL(asked, consider(Ref(map), place, 5)).WillOnce(Return(Action::reset()));
  EXPECT_CALL(asked, show(place.pose, seen));
  EXPECT_CALL(asked, carried(7));
  EXPECT_CALL(asked, pace(true)).WillOnce(Return(0.5));
  EXPECT_CALL(asked, searches_at(0.25));
  EXPECT_CALL(asked, map_kind).WillOnce(Return(MapKind::log_odds));
  EXPECT_CALL(asked, plans).WillOnce(Return(3));
  EXPECT_EQ(driver.consider(map, place, 5), Action::reset());
  driver.show(place.pose, seen);
  driver.carried(7);
  EXPECT_EQ(driver.pace(true), 0.5);
  driver.searches_at(0.25);
  EXPECT_EQ(driver.map_kind(), MapKind::log_odds);
  EXPECT_EQ(driver.plans(), 3);
}

}  // namespace
}  // namespace labmouse
