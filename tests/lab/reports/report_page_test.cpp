#include "labmouse/lab/reports/report_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "labmouse/lab/mazes/maze_link.hpp"
#include "labmouse/lab/records/mms_record.hpp"
#include "labmouse/lab/records/packed_record.hpp"
#include "labmouse/lab/reports/report_records.hpp"
#include "labmouse/lab/result_folders/race_folder.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/system/files.hpp"
#include "tests/lab/mms/mms_fixture.hpp"
#include "tests/lab/records/record_fixture.hpp"
#include "tests/lab/reports/unpacking.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::block_of;
using test::Says;
using test::SaysAt;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

using Json = nlohmann::ordered_json;

constexpr const char* page = "<html><body><!-- labmouse:report --><script>code</script></body></html>";

/// A race whose files lie in a folder.
class AReport : public testing::Test {
 protected:
  void hold(std::vector<Contestant> mice, std::vector<NamedMaze> mazes, const RaceOrder& order = test::in_steps()) {
    std::optional<RaceFolder> kept;
    RaceHooks hooks;
    hooks.keep = RaceFolder::keep;
    hooks.finished = [&](const Race& race, const ContestResult& contest, const ContestOutput& held) {
      if (!kept) kept.emplace(folder_.path(), race);
      EXPECT_EQ(kept->save(contest, held), "");
    };
    race_ = hold_race(std::move(mice), std::move(mazes), order, hooks);
    json_ = json_of(race_, {});
    save("results.json", json_);
  }
  /// The same as `labmouse race --mice flood,random --runs 3 --out`.
  void hold_small() {
    RaceOrder order = test::in_steps();
    order.runs = 3;
    hold(test::mice("flood,random"), {test::loop(), test::corridor()}, order);
  }

  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
  void save(const std::string& name, const std::string& content) const {
    EXPECT_EQ(write_file(path(name), content), "");
  }
  std::string content(const std::string& name) const { return read_file(path(name)).content; }

  ReportPage made(const std::string& name = "") const {
    ReportPage report = make_report(name.empty() ? folder_.path() : path(name), page);
    EXPECT_EQ(report.page.empty(), !report.error.empty());
    return report;
  }
  Json records(const std::string& name = "") const { return block_of(made(name).page, "labmouse-records"); }

  test::AFolder folder_;
  Race race_;
  std::string json_;
};

TEST_F(AReport, HoldsTheResultsAsTheyAre) {
  hold_small();
  const ReportPage report = made();
  EXPECT_EQ(report.error, "");
  EXPECT_THAT(report.notes, IsEmpty());
  const Json block = block_of(report.page, "labmouse-report");
  EXPECT_EQ(block["labmouse"], "report");
  EXPECT_EQ(block["format"], 2);
  EXPECT_EQ(block["results"].dump(), Json::parse(json_).dump());
}

TEST_F(AReport, HoldsTheMazesAsLinks) {
  NamedMaze elsewhere = test::loop();
  elsewhere.maze = elsewhere.maze.with_start({4, 3}, Heading::west);
  hold(test::mice("flood"), {elsewhere, test::corridor()});
  const Json mazes = block_of(made().page, "labmouse-report")["mazes"];
  ASSERT_EQ(mazes.size(), 2U);
  const ReadLinkResult read = read_link(mazes["loop"].get<std::string>());
  ASSERT_TRUE(read.maze);
  EXPECT_EQ(read.maze->maze, elsewhere.maze);
  EXPECT_EQ(read.maze->name, "loop");
}

TEST_F(AReport, HoldsTheFirstRecordOfEachMouseInEachMaze) {
  hold_small();
  const Json block = records();
  EXPECT_EQ(block["left_out"], 0);
  ASSERT_EQ(block["records"].size(), 4U);
  for (const Json& packed : block["records"]) {
    const std::string mouse = packed["mouse"], maze = packed["maze"];
    EXPECT_EQ(packed["seed"], contest_seed(1, maze, 0));
    const RecordFile file = test::read(content(mouse + "/" + maze + "-1.jsonl"));
    EXPECT_EQ(packed.dump(), pack_record(file).dump());
  }
}

TEST_F(AReport, StandsInThePlaceThatThePageHasForIt) {
  hold_small();
  const std::string text = made().page;
  EXPECT_EQ(text.find("<html><body><script type=\"text/plain\" id=\"labmouse-report\">"), 0U);
  EXPECT_THAT(text, HasSubstr("</script>\n<script type=\"text/plain\" id=\"labmouse-records\">"));
  EXPECT_THAT(text, testing::EndsWith("</script>\n<script>code</script></body></html>"));
}

TEST_F(AReport, OfTheSameFilesHasTheSameBytes) {
  hold_small();
  const std::string first = made().page;
  EXPECT_EQ(made().page, first);
  EXPECT_EQ(made("results.json").page, first);
}

TEST_F(AReport, TakesJsonAlone) {
  hold(test::mice("flood"), {{"contest-01", *maze_named("contest-01")}, test::loop()});
  save("alone/today.json", json_);
  const ReportPage report = made("alone/today.json");
  EXPECT_EQ(report.error, "");
  EXPECT_EQ(block_of(report.page, "labmouse-records").dump(), R"({"records":[],"left_out":0})");
  const Json mazes = block_of(report.page, "labmouse-report")["mazes"];
  ASSERT_EQ(mazes.size(), 1U);
  EXPECT_EQ(read_link(mazes["contest-01"].get<std::string>()).maze->maze, *maze_named("contest-01"));
  EXPECT_THAT(report.notes, ElementsAre(Says("1 maze", "found again", "loop")));
}

TEST_F(AReport, FindsNoMazeThatHasChangedSince) {
  const std::string file = path("maze.txt");
  save("maze.txt", *drawing_format.write(test::loop().maze).content);
  hold(test::mice("flood"), {{file, test::loop().maze}});
  save("alone/today.json", json_);
  const auto mazes = [&] { return block_of(made("alone/today.json").page, "labmouse-report")["mazes"].size(); };
  EXPECT_EQ(mazes(), 1U);
  save("maze.txt", *drawing_format.write(test::loop().maze.with_start({4, 0}, Heading::north)).content);
  EXPECT_EQ(mazes(), 0U);
  std::filesystem::remove(file);
  EXPECT_EQ(mazes(), 0U);
}

TEST_F(AReport, FindsNoMazeOfAnotherSize) {
  const std::string file = path("maze.txt");
  save("maze.txt", *drawing_format.write(test::without_route().maze).content);
  hold(test::mice("flood"), {{file, test::without_route().maze}});
  save("alone/today.json", json_);
  EXPECT_THAT(made("alone/today.json").notes, IsEmpty());
  save("maze.txt", *drawing_format.write(test::corridor().maze).content);
  EXPECT_THAT(made("alone/today.json").notes, ElementsAre(Says("1 maze", "found again", file)));
}

TEST_F(AReport, LeavesOutARecordThatCannotBeRead) {
  hold_small();
  save("flood/loop-1.jsonl",
       content("flood/loop-1.jsonl").insert(content("flood/loop-1.jsonl").find('\n') + 1, "oops\n"));
  const ReportPage report = made();
  EXPECT_THAT(report.notes, ElementsAre(SaysAt(path("flood/loop-1.jsonl") + ":2:1", "JSON")));
  EXPECT_EQ(block_of(report.page, "labmouse-records")["records"].size(), 3U);
}

TEST_F(AReport, LeavesOutARecordThatCouldNotHaveHappened) {
  hold_small();
  save("flood/loop-1.jsonl", test::changed(content("flood/loop-1.jsonl"), "\"reading\":[0,", "\"reading\":[1,"));
  EXPECT_THAT(made().notes, ElementsAre(Says("loop-1.jsonl: error: ", "step 1:")));
}

TEST_F(AReport, LeavesOutARecordOfAnotherRace) {
  hold_small();
  const auto notes_of = [&](const RecordFile& file) {
    save("flood/loop-1.jsonl", write_record(file));
    return made().notes;
  };
  EXPECT_THAT(notes_of(test::recorded("flood", test::loop(), 7)), ElementsAre(Says("flood in loop", "seed 7")));
  const std::uint64_t seed = contest_seed(1, "loop", 0);
  EXPECT_THAT(notes_of(test::recorded("certify", test::loop(), seed)), ElementsAre(HasSubstr("certify in loop")));
  EXPECT_THAT(notes_of(test::recorded("flood", test::hook(), seed)), ElementsAre(HasSubstr("flood in hook")));
  EXPECT_THAT(notes_of(test::recorded("flood", {"loop", test::hook().maze}, seed)).size(), 1U);
  EXPECT_THAT(notes_of(test::recorded("flood", test::loop(), seed)), IsEmpty());
}

TEST_F(AReport, SaysHowManyRecordsAreGone) {
  hold_small();
  std::filesystem::remove(path("flood/loop-1.jsonl"));
  EXPECT_THAT(made().notes, ElementsAre(Says("left out", "1 record", folder_.path())));
}

TEST_F(AReport, SaysHowManyRecordsDoNotFit) {
  hold_small();
  const ReadResultsResult read = read_report_results(json_);
  const std::size_t all = read_report_records(*read.results, folder_.path()).json.size();
  const ReportRecords some = read_report_records(*read.results, folder_.path(), all / 2);
  const Json block = Json::parse(some.json);
  const std::size_t kept = block["records"].size();
  EXPECT_GT(kept, 0U);
  EXPECT_EQ(block["left_out"], 4U - kept);
  EXPECT_LE(some.json.size(), all / 2 + 40);
  EXPECT_THAT(some.notes, ElementsAre(Says(std::to_string(4U - kept) + " of 4 records", "bytes")));
}

TEST_F(AReport, FindsTheRecordsOfMiceThatAreNotBestInTheOrderOfTheirNames) {
  hold(test::mice("flood:stride=1,flood:stride=2"), {test::loop()});
  const ReportPage report = made();
  EXPECT_THAT(report.notes, IsEmpty());
  const Json list = block_of(report.page, "labmouse-records")["records"];
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0]["mouse"], "flood:stride=2");
  EXPECT_EQ(list[1]["mouse"], "flood:stride=1");
}

TEST_F(AReport, FindsTheRecordsOfMazesWithOneName) {
  hold(test::mice("flood"), {{"one/maze.txt", test::loop().maze}, {"two/maze.txt", test::corridor().maze}});
  const Json list = records()["records"];
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0]["maze"], "one/maze.txt");
  EXPECT_EQ(list[1]["maze"], "two/maze.txt");
}

TEST_F(AReport, IsSafeFromHostileNames) {
  const std::string name = "</script><script>alert(1)</script>\"'&\xff<!--";
  hold(test::mice("flood"), {{name, test::loop().maze}});
  const ReportPage report = made();
  EXPECT_EQ(report.error, "");
  EXPECT_THAT(report.page, Not(HasSubstr("alert")));
  const Json block = block_of(report.page, "labmouse-report");
  const std::string shown = "</script><script>alert(1)</script>\"'&\xEF\xBF\xBD<!--";
  EXPECT_EQ(block["results"]["groups"][0]["mazes"][0]["name"], shown);
  EXPECT_EQ(records()["records"].size() + made().notes.size(), 1U);
}

TEST_F(AReport, SaysWhatIsWrongWithItsInput) {
  const auto error = [&](const std::string& name) { return make_report(path(name), page).error; };
  EXPECT_THAT(error("nowhere"), SaysAt(path("nowhere"), "no such"));
  std::filesystem::create_directories(path("empty"));
  EXPECT_THAT(error("empty"), SaysAt(path("empty"), "results.json", "--out"));
  save("bad.json", "{\"labmouse\": \"1\",\n oops}");
  EXPECT_THAT(error("bad.json"), SaysAt(path("bad.json") + ":2:2", "JSON"));
  save("record.jsonl", write_record(test::recorded("flood")));
  EXPECT_THAT(error("record.jsonl"), SaysAt(path("record.jsonl"), "record of one contest"));
}

TEST(ThePage, HasOnePlaceForAReport) {
  EXPECT_EQ(wrong_page(page), "");
  EXPECT_THAT(wrong_page("<html></html>"), HasSubstr("no <!-- labmouse:report -->"));
  EXPECT_THAT(wrong_page(std::string(page) + page), HasSubstr("more than one"));
  EXPECT_THAT(wrong_page(with_report(page, "{}", "{}")), HasSubstr("no <!-- labmouse:report -->"));
}

TEST_F(AReport, HoldsRecordsOfMmsAsTheyAre) {
  hold({test::mms_mouse("left", {"ask:turnLeft"})}, {test::plank()}, test::in_mms());
  const ReportPage report = made();
  EXPECT_THAT(report.notes, IsEmpty());
  const Json list = block_of(report.page, "labmouse-records")["records"];
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0]["mouse"], "mms:left");
  EXPECT_EQ(list[0]["maze"], "plank");
  EXPECT_EQ(list[0]["mms"], content("mms_left/plank.jsonl"));
  EXPECT_TRUE(block_of(report.page, "labmouse-report")["mazes"].contains("plank"));
}

TEST_F(AReport, LeavesOutBadRecordsOfMms) {
  hold({test::mms_mouse("left", {"ask:turnLeft"})}, {test::plank()}, test::in_mms());
  const auto notes_of = [&](const std::string& record) {
    save("mms_left/plank.jsonl", record);
    return made().notes;
  };
  const std::string record = content("mms_left/plank.jsonl");
  EXPECT_THAT(notes_of(MmsRecorder("mms:right", test::plank()).finish({})),
              testing::Contains(HasSubstr("mms:right in plank")));
  EXPECT_THAT(notes_of(record + "{oops\n"), testing::Contains(Says("plank.jsonl:4:", ": error: ", "JSON")));
  EXPECT_THAT(notes_of(write_record(test::recorded("flood"))),
              testing::Contains(Says("plank.jsonl:1:1: error: ", "header", "mms")));
}

}  // namespace
}  // namespace labmouse
