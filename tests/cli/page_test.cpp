// labmouse page and labmouse report, with a page of one line, so that nothing depends on whether the real one was
// built.
#include <map>

#include "tests/cli/user.hpp"
#include "tests/lab/reports/unpacking.hpp"

namespace labmouse {
namespace {

using test::AUser;
using test::corridor;
using test::Ended;
using test::Says;
using test::SaysAt;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* small_page = "<!doctype html><title>labmouse</title><!-- labmouse:report -->\n";

/// A user with a page and the folder of a race.
class AReader : public AUser {
 protected:
  AReader() {
    file("page.html", small_page);
    file("corridor.txt", corridor);
    const Ended race = labmouse({"race", "--mice", "flood,random", "--runs", "2", "--mazes", "corridor.txt",
                                 "capstone-1", "--out", "out", "--format", "json"});
    EXPECT_EQ(race.code, 0) << race.err;
    file("today.json", race.out);
  }
  Ended report(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"report", "--page", "page.html"});
    return labmouse(std::move(arguments));
  }
};

TEST_F(AUser, GetsThePageOrIsToldHowToBuildIt) {
  const Ended page = labmouse({"page", "-o", "-"});
  if (page.code == 0) {
    EXPECT_THAT(page.out, HasSubstr("<!-- labmouse:report -->"));
    EXPECT_EQ(labmouse({"page", "-o", "new/labmouse.html"}).code, 0);
    EXPECT_EQ(content("new/labmouse.html"), page.out);
    return;
  }
  is_refused({"page", "-o", "-"}, "`make page`", "--page");
  is_refused({"report", ".", "-o", "-"}, "`make page`");
}

TEST_F(AReader, GetsThePageThatWasNamed) {
  EXPECT_EQ(labmouse({"page", "--page", "page.html", "-o", "-"}).out, small_page);
  const Ended saved = labmouse({"page", "--page", "page.html", "-o", "folder/copy.html"});
  EXPECT_EQ(saved.code, 0);
  EXPECT_EQ(saved.out + saved.err, "");
  EXPECT_EQ(content("folder/copy.html"), small_page);
}

TEST_F(AReader, SeesADemoInTheBrowserThatIsNamed) {
  const Ended demo = labmouse({"demo", "--page", "page.html"}, "BROWSER=echo");
  EXPECT_EQ(demo.code, 0) << demo.err;
  EXPECT_THAT(demo.out, EndsWith("\nlabmouse-demo.html\n"));
  // The report has times by the clock, the records have none.
  const auto records = test::block_of(content("labmouse-demo.html"), "labmouse-records").at("records");
  const auto results = test::block_of(content("labmouse-demo.html"), "labmouse-report");
  EXPECT_EQ(records.size(), 4 * 43);
  EXPECT_FALSE(results.is_null());

  file("mine.html", "not a page");
  is_refused({"demo", "--page", "page.html", "-o", "mine.html"}, "mine.html");
  EXPECT_EQ(labmouse({"demo", "--page", "page.html", "--no-browser", "-o", "2.html"}, "BROWSER=/none/such").code, 0);
  EXPECT_TRUE(test::block_of(content("2.html"), "labmouse-records").at("records") == records);
  EXPECT_EQ(content("mine.html"), "not a page");
}

TEST_F(AUser, LearnsWhatWorksOnThisMachine) {
  const Ended broken = labmouse({"doctor", "--format", "json"}, "LABMOUSE_PYTHON=false");
  EXPECT_EQ(broken.code, 0) << broken.err;
  const auto json = nlohmann::json::parse(broken.out, nullptr, false);
  ASSERT_TRUE(json.contains("parts")) << broken.out;
  std::map<std::string, bool> there;
  for (const auto& part : json["parts"]) {
    there[part["name"]] = part["there"];
    EXPECT_NE(part["needed_for"], "");
    EXPECT_NE(part["how_to_get"], "");
  }
  for (const char* name : {"Python", "labmouse for Python", "labmouse.fit", "terminal"}) {
    ASSERT_TRUE(there.contains(name)) << name;
    EXPECT_FALSE(there[name]) << name;
  }
  EXPECT_EQ(there["page"], labmouse({"page", "-o", "-"}).code == 0);
  file("python", "#!/bin/sh\necho 9.8.7\n");
  std::filesystem::permissions(folder_ / "python", std::filesystem::perms::owner_all);
  const Ended found = labmouse({"doctor"}, "LABMOUSE_PYTHON=./python");
  EXPECT_THAT(found.out, HasSubstr("9.8.7"));
}

TEST_F(AReader, GetsAReportOfAFolder) {
  const Ended ended = report({"out", "-o", "report.html"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.out + ended.err, "");
  const std::string text = content("report.html");
  EXPECT_THAT(text, HasSubstr("<title>labmouse</title><script type=\"text/plain\" id=\"labmouse-report\">"));
  EXPECT_THAT(text, HasSubstr("id=\"labmouse-records\">"));
  EXPECT_EQ(report({"out", "-o", "-"}).out, text);
  EXPECT_EQ(report({"out/results.json", "-o", "-"}).out, text);
}

TEST_F(AReader, GetsAReportOfJsonAlone) {
  const Ended ended = report({"today.json", "-o", "-"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_LT(ended.out.size(), report({"out", "-o", "-"}).out.size());
  std::filesystem::remove(folder_ / "corridor.txt");
  const Ended lost = report({"today.json", "-o", "-"});
  EXPECT_EQ(lost.code, 0);
  EXPECT_THAT(lost.err, Says("1 maze", "found again", "corridor.txt"));
}

TEST_F(AReader, IsToldOfRecordsThatAreLeftOut) {
  file("out/flood/capstone-1-1.jsonl", "oops\n");
  const Ended one = report({"out", "-o", "report.html"});
  EXPECT_EQ(one.code, 0);
  EXPECT_THAT(one.err, SaysAt("out/flood/capstone-1-1.jsonl:1:1", "JSON"));
  std::vector<std::string> mice = {"race", "--mazes", "corridor.txt", "--runs", "1", "--out", "many"};
  EXPECT_EQ(labmouse(mice).code, 0);
  for (const auto& mouse : std::filesystem::directory_iterator(folder_ / "many"))
    if (mouse.is_directory()) std::ofstream(mouse.path() / "corridor-1.jsonl") << "oops\n";
  const Ended all = report({"many", "-o", "report.html"});
  EXPECT_EQ(std::count(all.err.begin(), all.err.end(), '\n'), 11);
  EXPECT_THAT(all.err, testing::ContainsRegex("\\.\\.\\. and [0-9]+ more\n$"));
}

TEST_F(AReader, IsRefusedWhatIsNoRace) {
  file("bad.json", "{\"labmouse\": \"1\",\n oops}");
  const auto refused = [&](const std::string& results, auto... parts) {
    is_refused({"report", results, "--page", "page.html", "-o", "report.html"}, parts...);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "report.html"));
  };
  refused("bad.json", "bad.json:2:2: error: ", "JSON");
  refused("corridor.txt", "corridor.txt: error: ", "is a maze");
  refused("out/flood/corridor-1.jsonl", "corridor-1.jsonl: error: ", "record", "race");
  refused("out/flood", "out/flood: error: ", "results.json");
  refused("nowhere", "nowhere: error: ", "no such");
  refused("no\x1b[31mwhere", "no[31mwhere: error: ", "no such");
}

TEST_F(AReader, IsRefusedWhatIsNoPage) {
  is_refused({"page", "--page", "corridor.txt", "-o", "-"}, "corridor.txt: error: ", "<!-- labmouse:report -->");
  is_refused({"page", "--page", "nowhere.html", "-o", "-"}, "nowhere.html: error: ", "no such");
  is_refused({"page"}, "'--out'", "missing");
  is_refused({"report", "out", "--page", "page.html"}, "'--out'", "missing");
  is_refused({"report", "--page", "page.html", "-o", "-"}, "error: 'results' ", "missing");
  is_refused({"report", "out", "--page", "page.html", "-o", "page.html/report.html"},
             "page.html/report.html: error: ", "not a folder");
  EXPECT_EQ(report({"out", "-o", "report.html"}).code, 0);
  is_refused({"report", "out", "--page", "report.html", "-o", "-"}, "report.html: error: ", "<!-- labmouse:report -->");
}

TEST_F(AReader, MaySendItsNamesWithoutHarm) {
  const std::string name = "<script>alert(1)<\xff.txt";
  file(name, corridor);
  EXPECT_EQ(labmouse({"race", "--mice", "flood", "--mazes", name, "--out", "hostile"}).code, 0);
  const Ended ended = report({"hostile", "-o", "-"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, Not(HasSubstr("alert")));
}

}  // namespace
}  // namespace labmouse
