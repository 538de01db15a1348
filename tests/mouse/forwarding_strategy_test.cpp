#include "labmouse/mouse/forwarding_strategy.hpp"

#include <gmock/gmock.h>

#include <array>

namespace labmouse {
namespace {

using testing::Return;
using testing::ReturnRef;

class AskedStrategy : public Strategy {
 public:
  MOCK_METHOD(Action, decide, (const Sighting&), (override));
  MOCK_METHOD(void, show, (const Pose&, const Sighting&), (override));
  MOCK_METHOD(void, carried, (std::int64_t), (override));
  MOCK_METHOD(bool, considers, (), (const, override));
  MOCK_METHOD(double, pace, (bool), (override));
  MOCK_METHOD(void, searches_at, (double), (override));
  MOCK_METHOD(std::optional<MapKind>, map_kind, (), (const, override));
  MOCK_METHOD(const Knowledge&, knowledge, (), (const, override));
  MOCK_METHOD(std::span<const Counter>, counters, (), (const, override));
  MOCK_METHOD(std::string_view, last_words, (), (override));
  MOCK_METHOD(std::optional<double>, microseconds, (), (const, override));
  MOCK_METHOD(bool, started, (), (const, override));
  MOCK_METHOD(void, keep_reasons, (), (override));
  MOCK_METHOD(const Reasons*, reasons, (), (const, override));
};

TEST(ForwardingStrategy, ForwardsCalls) {
  testing::StrictMock<AskedStrategy> asked;
  ForwardingStrategy forwarding(asked);
  Strategy& strategy = forwarding;
  const Knowledge knowledge({4, 4});
  const Reasons reasons;
  const std::array<Counter, 1> counters = {{{"nodes", 3}}};
  EXPECT_CALL(asked, decide).WillOnce(Return(Action::step(90, 2)));
  EXPECT_CALL(asked, show);
  EXPECT_CALL(asked, carried(7));
  EXPECT_CALL(asked, considers).WillOnce(Return(true));
  EXPECT_CALL(asked, pace(true)).WillOnce(Return(0.5));
  EXPECT_CALL(asked, searches_at(0.25));
  EXPECT_CALL(asked, map_kind).WillOnce(Return(MapKind::belief));
  EXPECT_CALL(asked, knowledge).WillOnce(ReturnRef(knowledge));
  EXPECT_CALL(asked, counters).WillOnce(Return(std::span<const Counter>(counters)));
  EXPECT_CALL(asked, last_words).WillOnce(Return("lost"));
  EXPECT_CALL(asked, microseconds).WillOnce(Return(1.5));
  EXPECT_CALL(asked, started).WillOnce(Return(false));
  EXPECT_CALL(asked, keep_reasons);
  EXPECT_CALL(asked, reasons).WillOnce(Return(&reasons));
  EXPECT_EQ(strategy.decide({}), Action::step(90, 2));
  strategy.show({}, {});
  strategy.carried(7);
  EXPECT_TRUE(strategy.considers());
  EXPECT_EQ(strategy.pace(true), 0.5);
  strategy.searches_at(0.25);
  EXPECT_EQ(strategy.map_kind(), MapKind::belief);
  EXPECT_EQ(&strategy.knowledge(), &knowledge);
  EXPECT_EQ(strategy.counters().data(), counters.data());
  EXPECT_EQ(strategy.last_words(), "lost");
  EXPECT_EQ(strategy.microseconds(), 1.5);
  EXPECT_FALSE(strategy.started());
  strategy.keep_reasons();
  EXPECT_EQ(strategy.reasons(), &reasons);
}

}  // namespace
}  // namespace labmouse
