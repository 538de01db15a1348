// Comparisons of mice in the page, batch by batch, against those of the library.
#include <gmock/gmock.h>

#include "labmouse/lab/studies/compare.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::answer;
using test::data_of;
using test::error_of;
using test::json;
using test::Says;

json order_of(const json& mice, const json& more) {
  json order = {{"mice", mice}, {"seed", 3}, {"most", 100}, {"better_by", 0.02}, {"alpha", 0.05}, {"beta", 0.05}};
  order.update(more);
  return order;
}

/// What the page does.
json compared_in_batches(json order) {
  json verdict, shares = json::array();
  do {
    order["begin"] = shares.size();
    order["shares"] = shares;
    const json batch = answer("paired_shares", order)["shares"];
    shares.insert(shares.end(), batch.begin(), batch.end());
    order["shares"] = shares;
    verdict = answer("verdict", order);
  } while (!verdict["over"].get<bool>());
  return verdict["comparison"];
}

CompareOrder library_order(const char* world) {
  CompareOrder order;
  order.race.world = find_world(world)->make({}).world;
  order.race.seed = 3;
  order.most = 100;
  return order;
}

TEST(PagePaired, HasTheComparisonsOfTheLibraryInEveryWorld) {
  const json prim = {{"generator", "prim"}, {"width", 5}, {"height", 5}, {"loops", 0.1}};
  for (const char* world : {"steps", "physical"}) {
    json given = prim;
    given["world"] = world;
    CompareOrder order = library_order(world);
    order.mazes.generator = &prim_generator;
    order.mazes.order = {{5, 5}, 3, 100};
    const bool in_steps = order.race.world->traits().name == "steps";
    // Each of the two tests once.
    given["test"] = in_steps ? "gsprt" : "bets";
    order.test.method = in_steps ? SequentialMethod::gsprt : SequentialMethod::bets;
    const char* mice = in_steps ? "random,random-move,certify" : "flood-return,flood";
    order.test.better_by = given["better_by"] = in_steps ? 0.02 : 0.2;
    const json held = json::parse(json_of(hold_comparison(test::mice(mice), order)));
    const json list = in_steps ? json{"random", "random-move", "certify"} : json{"flood-return", "flood"};
    EXPECT_EQ(compared_in_batches(order_of(list, given)), held) << world;
    EXPECT_GE(held["raced_in"], in_steps ? 33 : 1) << "one batch shows little";
  }
}

TEST(PagePaired, IsExactInAListWithoutChance) {
  const json list = {data_of(test::loop()), data_of(test::corridor()), data_of(test::without_route())};
  CompareOrder order = library_order("steps");
  order.mazes.list = {test::loop(), test::corridor(), test::without_route()};
  const json compared = compared_in_batches(order_of({"flood", "certify"}, {{"mazes", list}}));
  EXPECT_EQ(compared, json::parse(json_of(hold_comparison(test::mice("flood,certify"), order))));
  EXPECT_EQ(compared["exact"], true);
}

TEST(PagePaired, RefusesWhatIsNoComparison) {
  const json prim = {{"generator", "prim"}, {"width", 5}, {"height", 5}, {"loops", 0}};
  const auto refused = [&](const char* call, const json& mice, const json& more) {
    json order = order_of(mice, prim);
    order.update({{"begin", 0}, {"shares", json::array()}});
    order.update(more);
    return error_of(call, order);
  };
  EXPECT_THAT(refused("verdict", {"flood"}, {{"alpha", 0.1}}), Says("two mice"));
  EXPECT_THAT(refused("verdict", {"flood", "certify"}, {{"better_by", 0}}), Says("better_by"));
  EXPECT_THAT(refused("verdict", {"flood", "certify"}, {{"test", "t"}}), Says("'test'", "gsprt"));
  EXPECT_THAT(refused("paired_shares", {"flood", "certify"}, {{"begin", 5}}), Says("'begin'"));
  EXPECT_THAT(refused("paired_shares", {"flood", "certify"}, {{"generator", "x"}}), Says("generator 'x'"));
  EXPECT_THAT(refused("paired_shares", {"flood", "certify"}, {{"mazes", json::array()}}), Says("maze"));
  for (const json& shares : {json{{0.5}}, json{{0.5, 2}}, json{{0.5, "x"}}, json{3}, json{{nullptr, nullptr, nullptr}}})
    EXPECT_THAT(refused("verdict", {"flood", "certify"}, {{"shares", shares}}), Says("'shares'")) << shares;
}

}  // namespace
}  // namespace labmouse
