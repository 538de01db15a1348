#include "labmouse/lab/text/former_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>

#include "labmouse/lab/races/earlier_results.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_fields.hpp"

namespace labmouse {
namespace {

TEST(FormerNames, AreReadAtEveryDepth) {
  const Json old = read_ordered_json(
      R"({"spread":2,"map":"belief","list":[{"outcome":"solved","misreads":3,"name":"solved"}],"ended_by":"walled in"})");
  EXPECT_EQ(with_today_names(old).dump(),
            R"({"variation":2,"map":"log-odds","list":[{"outcome":"finished","wrong_walls":3,"name":"solved"}],)"
            R"("ended_by":"no route left"})");
}

TEST(FormerNames, AreThoseThatStoresKeep) {
  const Json today = read_ordered_json(R"({"failure_rates":"kerise","map":"log-odds-prior","budget":5})");
  EXPECT_EQ(with_names(today, former_key, former_value).dump(), R"({"hazards":"kerise","map":"learned","budget":5})");
}

TEST(FormerNames, OfKeysAreFoundWhereTodaysAreMissing) {
  const ReadJson old = read_json(R"({"exploration_steps":7})"), both = read_json(R"({"spread":1,"variation":2})");
  JsonFields fields(old, ""), two(both, "");
  EXPECT_EQ(fields.whole("search_steps", 0, 9), 7);
  EXPECT_FALSE(fields.has("speed_steps"));
  EXPECT_EQ(two.whole("variation", 0, 9), 2);
}

TEST(FormerNames, OfSpecsAreThoseOfTheirKind) {
  EXPECT_EQ(today_spec("guest:./a b"), "program:./a b");
  EXPECT_EQ(today_spec("pilot:./a"), "controller:./a");
  EXPECT_EQ(today_spec("lineup:a.toml:b"), "mice-file:a.toml:b");
  EXPECT_EQ(today_spec("program:guest:"), "program:guest:");
}

TEST(FormerNames, OfResultsInStepsAreTodaysInTheirGroup) {
  const Json old =
      read_ordered_json(R"({"mice":[{"solved":1,"penalised_mean":9.5,"results":[{"outcome":"solved"}]}]})");
  const Json mouse = with_groups(old)["groups"][0]["mice"][0];
  EXPECT_EQ(mouse["finished"], 1);
  EXPECT_EQ(mouse["mean_par1"], 9.5);
  EXPECT_EQ(mouse["results"][0]["outcome"], "finished");
}

TEST(FormerNames, StandInTheManualAndNameOneThingEach) {
  const std::string page = read_file(LABMOUSE_SOURCE_DIR "/docs/reference/files.md").content;
  const auto expect_listed = [&](const auto& names) {
    std::set<std::string_view> formers;
    for (const FormerName& each : names) {
      EXPECT_TRUE(formers.insert(each.former).second) << each.former;
      EXPECT_THAT(page, testing::HasSubstr("`" + std::string(each.former) + "`"));
    }
  };
  expect_listed(former_keys);
  expect_listed(former_values);
  expect_listed(former_kinds);
}

}  // namespace
}  // namespace labmouse
