// Files that are no stores, or damaged or hostile ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "labmouse/lab/store/schema.hpp"
#include "labmouse/lab/store/store_changes.hpp"
#include "labmouse/lab/store/stored_races.hpp"
#include "labmouse/lab/store/verification.hpp"
#include "labmouse/lab/text/json.hpp"
#include "tests/lab/store/store_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using test::AStore;
using test::Says;
using test::three_mice;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using Access = Database::Access;

TEST_F(AStore, IsNoOtherFile) {
  std::ofstream(path("text")) << "not a database" << std::string(4096, '.');
  EXPECT_THAT(Store(path("text")).finish(), HasSubstr("text: error: "));
  EXPECT_THAT(Store(folder_.string()).finish(), HasSubstr(": error: "));
  EXPECT_THAT(Store("/dev/full").finish(), HasSubstr("/dev/full: error: "));
  EXPECT_THAT(Store(path("none/results.db")).finish(), HasSubstr("none/results.db: error: "));
  EXPECT_THAT(Store("").finish(), HasSubstr("error: "));
  { Database(path("other.db"), Access::create).run("CREATE TABLE things (name TEXT)"); }
  EXPECT_THAT(Store(path("other.db")).finish(), HasSubstr("other.db: error: "));
  EXPECT_EQ(Database(path("other.db"), Access::read).number("SELECT count(*) FROM sqlite_master"), 1);
  EXPECT_THAT(stored_mice(path("missing.db"), {}).error, HasSubstr("missing.db: error: "));
  EXPECT_FALSE(fs::exists(path("missing.db")));
  std::ofstream(path("empty.db")).flush();
  EXPECT_THAT(stored_mice(path("empty.db"), {}).error, HasSubstr("empty.db: error: "));
  EXPECT_EQ(Store(path("empty.db")).finish(), "");
}

TEST_F(AStore, HasNothingInItsSchemaThatIsNotOfLabmouse) {
  const std::vector<std::pair<std::string, std::string>> foreign = {
      {"CREATE TRIGGER t AFTER INSERT ON contests BEGIN DELETE FROM mice; END", "trigger t"},
      {"CREATE VIEW v AS SELECT * FROM contests", "view v"},
      {"CREATE TABLE other (x)", "table other"},
      {"CREATE INDEX i ON mice (name)", "index i"},
      {"DROP VIEW results; CREATE VIEW results AS SELECT 1 AS id", "view results"},
      {"DROP VIEW pairs", "view pairs"}};
  for (const auto& [change, name] : foreign) {
    race("flood", {test::loop()}, test::in_steps(), "whole.db");
    fs::copy_file(path("whole.db"), path(), fs::copy_options::overwrite_existing);
    Database(path(), Access::write).run(change);
    EXPECT_THAT(Store(path()).finish(), Says("results.db", name));
    EXPECT_THAT(stored_mice(path(), {}).error, Says("results.db", name));
    EXPECT_THAT(verify_store(path(), {}, {}).error, Says("results.db", name));
    EXPECT_THAT(forget(path(), {}).error, Says("results.db", name));
    EXPECT_THAT(merge_stores({path("whole.db")}, path()).error, Says("results.db", name));
    EXPECT_THAT(merge_stores({path()}, path("whole.db")).error, Says("results.db", name));
  }
}

TEST_F(AStore, MayHaveStatisticsOfSqlite) {
  race("flood", {test::loop()});
  Database(path(), Access::write).run("ANALYZE");
  EXPECT_EQ(Store(path()).finish(), "");
  EXPECT_EQ(number("SELECT count(*) FROM sqlite_master WHERE name = 'sqlite_stat1'"), 1);
}

TEST_F(AStore, RunsNothingThatItsFileSays) {
  {
    Database database(path(), Access::create);
    database.run("CREATE TABLE a (x); CREATE TABLE b (x)");
    database.run("CREATE TRIGGER t AFTER INSERT ON a BEGIN INSERT INTO b VALUES (1); END");
  }
  Database database(path(), Access::write);
  EXPECT_EQ(database.number("PRAGMA trusted_schema"), 0);
  database.run("INSERT INTO a VALUES (1)");
  EXPECT_EQ(database.number("SELECT count(*) FROM b"), 0);
  database.run("PRAGMA writable_schema = ON; DELETE FROM sqlite_master");
  EXPECT_NE(database.error(), "");
}

TEST_F(AStore, IsCheckedBeforeARaceGoesOn) {
  constexpr std::size_t page = 4096, header = 100;
  race(three_mice);
  fs::copy_file(path(), path("holed.db"));
  {
    // The last page is of rows or of an index: what its header says is there no more.
    std::fstream file(path("holed.db"), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(fs::file_size(path()) - page + header));
    file << std::string(page - header, '\0');
  }
  EXPECT_THAT(Store(path("holed.db")).finish(), Says("holed.db", "damaged"));
  EXPECT_THAT(merge_stores({path()}, path("holed.db")).error, Says("holed.db", "damaged"));
  EXPECT_THAT(merge_stores({path("holed.db")}, path()).error, Says("holed.db", "damaged"));
  EXPECT_THAT(forget(path("holed.db"), {}).error, Says("holed.db", "damaged"));
}

TEST_F(AStore, MayHaveSeedsThatNoRaceHas) {
  race("flood");
  for (const char* seed : {"", "x", "-1", "18446744073709551616"}) {
    change(std::string("UPDATE contests SET race_seed = '") + seed + "'");
    EXPECT_THAT(stored_races(path(), {}).error, Says("damaged")) << seed;
    EXPECT_THAT(all_stored_contests(path(), {}).error, Says("damaged")) << seed;
  }
}

TEST_F(AStore, MayHaveParametersThatNoMouseHas) {
  race("flood");
  for (const char* parameters : {"", "[]", "null", "{"}) {
    change(std::string("UPDATE mice SET parameters = '") + parameters + "'");
    EXPECT_THAT(stored_races(path(), {}).error, Says("damaged")) << parameters;
  }
}

TEST_F(AStore, SaysThatItIsDamaged) {
  race(three_mice);
  const auto whole = fs::file_size(path());
  fs::copy_file(path(), path("cut.db"));
  fs::resize_file(path("cut.db"), whole / 2);
  EXPECT_THAT(Store(path("cut.db")).finish(), HasSubstr("cut.db: error: "));
  EXPECT_THAT(stored_mice(path("cut.db"), {}).error, HasSubstr("cut.db: error: "));
  fs::copy_file(path(), path("holed.db"));
  {
    std::fstream file(path("holed.db"), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(4096);
    file << std::string(static_cast<std::size_t>(whole) - 4096, '\x5a');
  }
  held_ = 0;
  const auto store = std::make_shared<Store>(path("holed.db"));
  RaceOrder order = test::in_steps();
  order.store = store;
  EXPECT_TRUE(hold_race(counted_mice("flood"), {test::loop()}, order).stopped);
  EXPECT_THAT(store->finish(), HasSubstr("holed.db: error: "));
  EXPECT_EQ(held_, 0U);
  EXPECT_THAT(verify_store(path("holed.db"), {}, {}).error, HasSubstr("holed.db: error: "));
}

TEST_F(AStore, IsNeverReadWithoutWhatADamagedPageHeld) {
  constexpr std::size_t page = 4096, header = 100;
  race(three_mice);
  const auto text_of = [](const std::string& file) {
    std::string text, error = export_store(file, {}, ExportFormat::csv, 0, [&](const std::string&lines) {
                        text += lines;
                        return true;
                      });
    return std::pair(text, error);
  };
  const auto whole = text_of(path());
  const std::size_t mice = stored_mice(path(), {}).mice.size();
  for (std::size_t at = page; at < fs::file_size(path()); at += page) {
    // The pages of SQLite begin with what is there; what they say of it may be gone.
    fs::copy_file(path(), path("holed.db"), fs::copy_options::overwrite_existing);
    {
      std::fstream file(path("holed.db"), std::ios::in | std::ios::out | std::ios::binary);
      file.seekp(static_cast<std::streamoff>(at + header));
      file << std::string(page - header, '\0');
    }
    const auto listed = stored_mice(path("holed.db"), {});
    EXPECT_TRUE(!listed.error.empty() || listed.mice.size() == mice) << at;
    const auto exported = text_of(path("holed.db"));
    EXPECT_TRUE(!exported.second.empty() || exported == whole) << at;
    EXPECT_NE(stored_races(path("holed.db"), {}).error.empty(), listed.error != "") << at;
  }
}

TEST_F(AStore, SaysWhatIsWrongWithItsRows) {
  race("flood", {test::loop()});
  change("UPDATE contests SET figures = '{'");
  EXPECT_THAT(stored_races(path(), {}).error, HasSubstr("results.db: error: "));
  race("flood", {test::loop()});
  EXPECT_EQ(held_, 1U);
  change("DELETE FROM mice");
  EXPECT_THAT(verify_store(path(), {}, {}).error, HasSubstr("results.db: error: "));
}

TEST_F(AStore, FindsWhatWasLeftInTheLogBesideIt) {
  race("flood", {test::loop()}, test::in_steps(), "other.db");
  {
    Database database = open("other.db");
    database.run("PRAGMA wal_autocheckpoint = 0");
    database.run("UPDATE contests SET outcome = 'from the log'");
    // As a crash leaves them: the main file without what is in the log.
    fs::copy_file(path("other.db"), path());
    fs::copy_file(path("other.db") + "-wal", path() + "-wal");
  }
  EXPECT_EQ(number("SELECT count(*) FROM contests WHERE outcome = 'from the log'"), 1);
}

/// What another user may do, where the tests run as root, for whom every file can be written.
class AnotherUser {
 public:
  AnotherUser() : was_(geteuid()) {
    if (was_ == 0 && seteuid(65534) != 0) std::abort();
  }
  AnotherUser(const AnotherUser&) = delete;
  AnotherUser& operator=(const AnotherUser&) = delete;
  ~AnotherUser() {
    if (was_ == 0 && seteuid(0) != 0) std::abort();
  }

 private:
  uid_t was_;
};

TEST_F(AStore, ThatCannotBeWrittenIsReadOnly) {
  race("flood", {test::loop()});
  fs::permissions(path(), fs::perms(0444));
  fs::permissions(folder_, fs::perms(0555));
  {
    const AnotherUser user;
    EXPECT_THAT(Store(path()).finish(), HasSubstr("results.db: error: cannot be written"));
    EXPECT_THAT(Store(path("new.db")).finish(), HasSubstr("new.db: error: cannot be "));
    EXPECT_THAT(stored_mice(path(), {}).mice, SizeIs(1));
    EXPECT_THAT(stored_races(path(), {}).races, SizeIs(1));
  }
  fs::permissions(folder_, fs::perms(0755));
  {
    const AnotherUser user;
    EXPECT_THAT(Store(path()).finish(), HasSubstr("results.db: error: cannot be written"));
    EXPECT_THAT(stored_mice(path(), {}).mice, SizeIs(1));
  }
}

/// Whoever walks such a text by recursion ends.
TEST_F(AStore, WithEndlesslyNestedTextsIsShownAndRefused) {
  constexpr int deep = 300'000;
  const std::string lists = std::string(deep, '[') + std::string(deep, ']');
  std::string objects;
  for (int i = 0; i < deep; ++i) objects += "{\"name\":";
  objects += "1" + std::string(deep, '}');
  for (const char* column :
       {"contests.fields", "contests.figures", "worlds.conditions", "mice.about", "mice.parameters"})
    for (const std::string& text : {lists, objects}) {
      SCOPED_TRACE(column);
      fs::remove(path());
      race("flood", {test::loop()});
      const std::string name = column;
      change("UPDATE " + name.substr(0, name.find('.')) + " SET " + name.substr(name.find('.') + 1) + " = '" + text +
             "'");
      std::size_t lines = 0;
      EXPECT_EQ(export_store(path(), {}, ExportFormat::json_lines, 0,
                             [&](const std::string& part) { return lines += part.size(), true; }),
                "");
      EXPECT_GT(lines, 0U);
      EXPECT_THAT(stored_mice(path(), {}).mice, SizeIs(1));
      stored_races(path(), {});
      verify_store(path(), {}, {1.0});
    }
}

TEST(Json, IsNotReadWhereItIsTooDeep) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_TRUE(read_json(nested(30)).is_array());
  EXPECT_TRUE(read_json(nested(1'000'000)).is_discarded());
  EXPECT_TRUE(read_ordered_json(nested(30)).is_array());
  EXPECT_TRUE(read_ordered_json(nested(1'000'000)).is_discarded());
  EXPECT_TRUE(read_json("no JSON").is_discarded());
  // Brackets in texts, and marks of quotation in those, are none.
  EXPECT_FALSE(is_too_deep("\"" + std::string(100, '[') + "\""));
  EXPECT_FALSE(is_too_deep(R"(["\"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[["])"));
  std::string many = "[";
  for (int i = 0; i < 1000; ++i) many += "[],";
  EXPECT_FALSE(is_too_deep(many + "[]]"));
}

}  // namespace
}  // namespace labmouse
