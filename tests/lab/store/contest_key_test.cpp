// Keys of contests in a store, and worlds made again from conditions.
#include "labmouse/lab/store/contest_key.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/store/store_fixture.hpp"

namespace labmouse {
namespace {

using test::AStore;
using ::testing::HasSubstr;

TEST_F(AStore, MakesWorldsAgainFromTheirConditions) {
  for (const WorldEntry* entry : all_worlds()) {
    const auto world = entry->make({}).world;
    const auto again = restore_world(entry->name, conditions_text(*world));
    ASSERT_TRUE(again) << entry->name;
    EXPECT_EQ(key_of(*again), key_of(*world));
    for (const char* wrong :
         {"", "{}", "[]", "null", "{\"budget\":-1}", "{\"budget\":\"x\"}", "{\"rules\":1,\"robot\":{}}"})
      EXPECT_FALSE(restore_world(entry->name, wrong)) << entry->name << wrong;
  }
  EXPECT_FALSE(restore_world("elsewhere", "{}"));
  const auto half = find_world("seconds")->make({{"robot", "half"}, {"rules", "thirtieth"}}).world;
  EXPECT_EQ(key_of(*restore_world("seconds", conditions_text(*half))), key_of(*half));
}

TEST(ContestKeys, OfAnExternalMouseThatIsDrivenNameWhatDrivesIt) {
  const Contestant program = read_specs("program:true").contestants.front(),
                   mms = read_specs("mms:true").contestants.front(),
                   controller = read_specs("controller:true").contestants.front();
  const auto key = [](const char* world, const Contestant& mouse) {
    return key_of(*find_world(world)->make({}).world, mouse);
  };
  for (const char* world : {"seconds", "failures", "physical"}) {
    EXPECT_THAT(key(world, program), HasSubstr("\ndriven 1\nsignature "));
    EXPECT_THAT(key(world, mms), HasSubstr("\ndriven 1\nsignature "));
  }
  EXPECT_EQ(key("steps", program), program.identity());
  EXPECT_EQ(key("mms", mms), mms.identity());
  EXPECT_EQ(key("physical", controller), controller.identity());
}

}  // namespace
}  // namespace labmouse
