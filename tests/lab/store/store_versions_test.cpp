// Stores of earlier and later versions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "labmouse/lab/store/schema.hpp"
#include "labmouse/lab/store/stored_races.hpp"
#include "tests/lab/store/store_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using test::AStore;

using test::Says;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using Access = Database::Access;

TEST_F(AStore, OfALaterVersionIsNotTouched) {
  race("flood", {test::loop()});
  change("PRAGMA user_version = 2");
  EXPECT_THAT(Store(path()).finish(), Says("results.db", "2", "1"));
  EXPECT_TRUE(Store(path()).failed());
  EXPECT_THAT(stored_mice(path(), {}).error, HasSubstr("results.db"));
  EXPECT_EQ(Database(path(), Access::read).number("PRAGMA user_version"), 2);
}

TEST_F(AStore, OfAnEarlierVersionIsBroughtToThePresentOne) {
  race("flood", {test::loop()});
  const std::vector<const char*> steps = {migrations()[0], "ALTER TABLE contests ADD COLUMN note TEXT",
                                          "UPDATE contests SET note = 'moved'"};
  EXPECT_NE(open_store(path(), Access::read, steps).error(), "");
  for (int i = 0; i < 2; ++i) {
    Database database = open_store(path(), Access::write, steps);
    EXPECT_EQ(database.error(), "");
    EXPECT_EQ(database.number("PRAGMA user_version"), 3);
    EXPECT_EQ(database.number("SELECT count(*) FROM contests WHERE note = 'moved'"), 1);
  }
}

TEST_F(AStore, StaysAsItWasWhereItCannotBeBroughtToThePresentVersion) {
  race("flood", {test::loop()});
  const std::vector<const char*> steps = {migrations()[0], "ALTER TABLE contests ADD COLUMN note TEXT",
                                          "UPDATE nothing SET note = 'moved'"};
  EXPECT_NE(open_store(path(), Access::write, steps).error(), "");
  EXPECT_EQ(number("PRAGMA user_version"), 1);
  EXPECT_EQ(number("SELECT count(*) FROM pragma_table_info('contests') WHERE name = 'note'"), 0);
  race("flood", {test::loop()});
  EXPECT_EQ(held_, 0U);
}

TEST_F(AStore, OfTheFirstVersionIsReadForEver) {
  std::ifstream file(fs::path(LABMOUSE_SOURCE_DIR) / "tests/data/store/version-1.sql");
  const std::string sql(std::istreambuf_iterator<char>(file), {});
  {
    Database database(path(), Access::create);
    database.run(sql);
    ASSERT_EQ(database.error(), "");
  }
  const StoredMice before = stored_mice(path(), {});
  EXPECT_EQ(Store(path()).finish(), "");
  const StoredMice mice = stored_mice(path(), {});
  ASSERT_THAT(mice.mice, SizeIs(3)) << mice.error;
  EXPECT_EQ(mice.mice[0].contests, 1);
  EXPECT_EQ(number("SELECT count(*) FROM pragma_integrity_check WHERE integrity_check <> 'ok'"), 0);
}

TEST_F(AStore, IsMadeOnceWhereTwoMakeIt) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) threads.emplace_back([&] { EXPECT_EQ(Store(path()).finish(), ""); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(number("PRAGMA user_version"), 1);
}

}  // namespace
}  // namespace labmouse
