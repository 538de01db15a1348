// labmouse league: a season of twelve entries, among them one that looks for what it must not see and one that breaks.
#include <sys/stat.h>

#include <filesystem>

#include "tests/cli/robots_in_python.hpp"
#include "tests/cli/user.hpp"

namespace labmouse::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

/// Follows the right wall. Ends with an error where it finds a file of the season, or of another entry.
std::string spy(const fs::path& folder) {
  return follower(
      "        here = os.path.dirname(os.path.abspath(__file__))\n"
      "        for season in ['" +
      (folder / "spring").string() + "', '" + (folder / "again").string() +
      "', os.path.dirname(os.path.dirname(here))]:\n"
      "            for name in ['secret-seed.txt', 'results.db', 'season.toml', 'practice/parallel-8.txt',\n"
      "                         'entries/flood_1/entry.toml', 'entries/wall_follower/robot.py', 'records']:\n"
      "                path = os.path.join(season, name)\n"
      "                try:\n"
      "                    found = os.listdir(path) if os.path.isdir(path) else open(path, 'rb').read()\n"
      "                except (IOError, OSError):\n"
      "                    found = ''\n"
      "                if found: raise ValueError('found ' + path)\n"
      "        told = ' '.join(sys.argv) + ' '.join(os.environ.values())\n"
      "        if 'parallel-8' in told or 'examination' in told: raise ValueError('told a maze')\n");
}

/// Holds a season; its entries lie in folders beside it.
class AnOrganiser : public AUser {
 protected:
  AnOrganiser() {
    file("page.html", small_page);
    file("seed.txt", std::string("# secret\n") + secret + "\n");
  }

  Ended init(const std::string& season, std::vector<std::string> more = {},
             const std::string& seed_file = "seed.txt") const {
    more.insert(more.begin(), {"league", "init", season, "--practice", "parallel-8,spiral-9", "--examination", "4",
                               "--kind", "prim", "--side", "8", "--seed-file", seed_file});
    return labmouse(std::move(more));
  }
  /// Makes the folder of an entry with that mouse, and with the text as robot.py.
  void entry(const std::string& name, const std::string& mouse, const std::string& robot = "") const {
    fs::create_directories(folder_ / name);
    file(name + "/entry.toml",
         "authors = [\"<Ada>\"]\nlicence = \"MIT\"\n[[mouse]]\nname = \"" + name + "\"\n" + mouse + "\n");
    if (!robot.empty()) file(name + "/robot.py", robot);
  }
  std::vector<std::string> twelve_entries() const {
    const std::string templates = std::string(LABMOUSE_SOURCE_DIR) + "/templates/";
    for (const char* stride : {"1", "2", "3"})
      entry("flood_" + std::string(stride), "mouse = \"flood:stride=" + std::string(stride) + "\"");
    entry("certain", "mouse = \"certify\"");
    entry("careful", "mouse = \"flood-return\"");
    entry("mine", "mouse = \"ariadne\"");
    entry("wall_follower", "capstone = \"robot.py\"", content_of(templates + "robots/wall_follower.py"));
    entry("flood_fill", "capstone = \"robot.py\"", content_of(templates + "robots/flood_fill.py"));
    entry("flood_and_return", "capstone = \"robot.py\"", content_of(templates + "robots/flood_and_return.py"));
    entry("lines", "program = \"python3 robot.py\"", content_of(templates + "program.py"));
    entry("spy", "capstone = \"robot.py\"", spy(folder_));
    entry("broken", "capstone = \"robot.py\"", crashing);
    return {"flood_1",       "flood_2",    "flood_3",          "certain", "careful", "mine",
            "wall_follower", "flood_fill", "flood_and_return", "lines",   "spy",     "broken"};
  }
  Ended add(const std::string& season, const std::string& name, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"league", "add", season, name});
    return labmouse(std::move(more));
  }
  void hold(const std::string& season) const {
    ASSERT_EQ(init(season).code, 0);
    for (const std::string& name : twelve_entries()) {
      const Ended added = add(season, name, {"--no-check"});
      ASSERT_EQ(added.code, 0) << added.err;
    }
  }
  nlohmann::json results(const std::string& site) const {
    return nlohmann::json::parse(content(site + "/results.json"), nullptr, false);
  }
  static nlohmann::json of(const nlohmann::json& results, const std::string& mouse) {
    for (const auto& one : results.at("mice"))
      if (one.at("name") == mouse) return one;
    ADD_FAILURE() << "no mouse " << mouse;
    return {};
  }
  bool has_sandboxes() const { return labmouse({"run", "program:true", "parallel-8", "--sandbox", "on"}).code != 2; }

  static constexpr const char* secret = "wet chalk and 41 lemons";
};

TEST_F(AnOrganiser, GetsTheSameBytesAgainFromTheSameSeed) {
  if (!has_sandboxes()) GTEST_SKIP() << "no sandboxes here";
  hold("spring");
  const Ended ran = labmouse({"league", "run", "spring", "--jobs", "1"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const Ended published =
      labmouse({"league", "publish", "spring", "-o", "site", "--page", "page.html", "--reveal", "--jobs", "1"});
  ASSERT_EQ(published.code, 0) << published.err;
  fs::create_directories(folder_ / "elsewhere");
  hold("elsewhere/summer");
  const Ended again = labmouse({"league", "publish", "elsewhere/summer", "-o", "elsewhere/pages", "--page", "page.html",
                                "--reveal", "--jobs", "2"});
  ASSERT_EQ(again.code, 0) << again.err;
  int files = 0;
  for (const auto& file : fs::directory_iterator(folder_ / "site")) {
    ++files;
    EXPECT_TRUE(content_of(file.path()) == content_of(folder_ / "elsewhere/pages" / file.path().filename()))
        << file.path();
  }
  EXPECT_EQ(files, 4);
  const auto all = results("site");
  // It ends with an error where it finds anything.
  EXPECT_EQ(of(all, "spy").at("finished"), 4);
  EXPECT_THAT(of(all, "spy").dump(), Not(HasSubstr("forfeit")));
  EXPECT_EQ(of(all, "broken").at("share_of_best"), 0.0);
  EXPECT_THAT(of(all, "broken").dump(), HasSubstr("forfeit"));
  EXPECT_EQ(of(all, "mine").at("finished"), 4);
  EXPECT_GT(of(all, "mine").at("share_of_best"), 0.5);
  EXPECT_LE(of(all, "mine").at("share_of_best"), 1.0);
  EXPECT_EQ(of(all, "mine").at("rank"), 1);
  EXPECT_EQ(all.at("mice").back().at("name"), "broken");
  EXPECT_EQ(of(all, "certain").at("authors")[0], "<Ada>");
  EXPECT_EQ(of(all, "ariadne").at("builtin"), true);
  const auto mice = all.at("mice").size();
  EXPECT_EQ(all.at("pairs").size(), mice * (mice - 1) / 2);
  EXPECT_THAT(content("site/index.html"), Not(HasSubstr("<Ada>")));
  EXPECT_THAT(content("site/index.html"), Not(HasSubstr("<script")));
}

// A second run takes all contests from the store; a changed entry is another mouse.
TEST_F(AnOrganiser, GoesOnWhereARunStopped) {
  ASSERT_EQ(init("spring").code, 0);
  entry("mine", "mouse = \"flood:stride=1\"");
  ASSERT_EQ(add("spring", "mine").code, 0);
  const auto run = [&] { return labmouse({"league", "run", "spring", "--sandbox", "off"}); };
  const auto stored = [&] {
    const std::string lines = labmouse({"store", "export", "spring/results.db"}).out;
    return std::count(lines.begin(), lines.end(), '\n');
  };
  const Ended first = run();
  ASSERT_EQ(first.code, 0) << first.err;
  const auto contests = stored();
  EXPECT_EQ(run().out, first.out);
  EXPECT_EQ(stored(), contests);
  fs::remove(folder_ / "spring/results.db");
  EXPECT_EQ(run().out, first.out);
  entry("mine", "mouse = \"flood:stride=2\"");
  EXPECT_EQ(add("spring", "mine").code, 2);
  EXPECT_EQ(add("spring", "mine", {"--replace"}).code, 0);
  EXPECT_EQ(run().code, 0);
  EXPECT_EQ(stored(), contests + 6);
}

TEST_F(AnOrganiser, FreezesWhatDecidesTheRanking) {
  file("mine.toml", content_of(LABMOUSE_SOURCE_DIR "/robots/half.toml"));
  file("seed.txt", secret);
  const Ended made = labmouse({"league", "init", "spring", "--world", "seconds", "--robot", "mine.toml", "--practice",
                               "contest-01", "--examination", "1", "--seed-file", "seed.txt"});
  ASSERT_EQ(made.code, 0) << made.err;
  const std::vector<std::string> run = {"league", "run", "spring", "--sandbox", "off"};
  ASSERT_EQ(labmouse(run).code, 0);
  for (const char* name : {"season.toml", "robot.toml", "practice/contest-01.txt", "season.sha256"}) {
    const std::string path = std::string("spring/") + name, good = content(path);
    file(path, good + "\n");
    is_refused(run, path);
    if (std::string(name) != "season.toml" && std::string(name) != "season.sha256") {
      fs::remove(folder_ / path);
      is_refused(run, path);
    }
    file(path, good);
  }
  const std::string list = content("spring/season.sha256");
  for (const std::string& damaged : {std::string(), list.substr(0, 70), std::string("rubbish\n")}) {
    file("spring/season.sha256", damaged);
    is_refused(run, "spring/season.sha256");
  }
  file("spring/season.sha256", list);
  file("spring/practice/more.txt", content("spring/practice/contest-01.txt"));
  is_refused(run, "spring/practice/more.txt");
  fs::remove(folder_ / "spring/practice/more.txt");
  file("spring/practice/.hidden", "x");
  const auto publish = [&] {
    return labmouse({"league", "publish", "spring", "-o", "site", "--page", "page.html", "--sandbox", "off"}).code;
  };
  ASSERT_EQ(publish(), 0);
  const std::string hash = results("site").at("season").at("season_sha256");
  EXPECT_EQ(hash.size(), 64);
  EXPECT_THAT(made.out, HasSubstr(hash));
  EXPECT_THAT(content("site/index.html"), HasSubstr(hash));
  fs::remove(folder_ / "spring/season.sha256");
  is_refused(run, "spring/season.sha256");
  // A season of an earlier labmouse has no such list, and does not say that it is frozen.
  std::string season = content("spring/season.toml");
  season.erase(season.find("frozen = true\n"), std::string("frozen = true\n").size());
  file("spring/season.toml", season);
  const Ended old = labmouse(run);
  EXPECT_EQ(old.code, 0);
  EXPECT_THAT(old.err, HasSubstr("season.sha256"));
  ASSERT_EQ(publish(), 0);
  EXPECT_FALSE(results("site").at("season").contains("season_sha256"));
}

TEST_F(AnOrganiser, KeepsTheSeedUntilTheSeasonEnds) {
  ASSERT_EQ(init("spring").code, 0);
  EXPECT_EQ(fs::status(folder_ / "spring/secret-seed.txt").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  const auto publish = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"league", "publish", "spring", "-o", "site", "--page", "page.html", "--sandbox", "off"});
    return labmouse(std::move(more)).code;
  };
  ASSERT_EQ(publish({}), 0);
  EXPECT_FALSE(fs::exists(folder_ / "site/examination.html"));
  for (const char* name : {"index.html", "results.json"}) {
    EXPECT_THAT(content("site/" + std::string(name)), Not(HasSubstr(secret)));
    EXPECT_THAT(content("site/" + std::string(name)),
                HasSubstr("4dbd06d504a78d6cc101c396bba918d7b339f6512e8403bfbb0a3cb3d88b8396"));
  }
  for (const auto& mouse : results("site").at("mice")) {
    EXPECT_FALSE(mouse.contains("examination"));
    EXPECT_EQ(mouse.at("practice").size(), 2);
  }
  EXPECT_THAT(content("site/results.json"), Not(HasSubstr("examination 0")));
  EXPECT_THAT(content("site/report.html"), Not(HasSubstr("examination 0")));
  ASSERT_EQ(publish({"--reveal"}), 0);
  EXPECT_EQ(results("site").at("mice")[0].at("examination").size(), 4);
  EXPECT_TRUE(fs::exists(folder_ / "site/examination.html"));
  EXPECT_EQ(results("site").at("season").at("examination_seed"), secret);
  file("spring/secret-seed.txt", "another secret seed\n");
  EXPECT_EQ(publish({}), 2);
  EXPECT_EQ(publish({"--seed-file", "seed.txt"}), 0);
}

TEST_F(AnOrganiser, BeginsWithTheTemplates) {
  ASSERT_EQ(init("spring", {"--templates"}).code, 0);
  const Ended ended =
      labmouse({"league", "publish", "spring", "-o", "site", "--page", "page.html", "--reveal", "--sandbox", "off"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  for (const char* name : {"flood_fill", "flood_and_return", "wall_follower"}) {
    const auto mouse = of(results("site"), std::string("template_") + name);
    EXPECT_GT(mouse.at("share_of_best"), 0.0) << name;
    EXPECT_EQ(mouse.at("licence"), "MIT");
  }
  is_refused({"league", "init", "summer", "--templates", "--world", "seconds"}, "--templates");
}

// The season does not change with the file that its robot came from.
TEST_F(AnOrganiser, KeepsTheRobotOfTheSeason) {
  file("mine.toml", content_of(LABMOUSE_SOURCE_DIR "/robots/half.toml"));
  ASSERT_EQ(init("spring", {"--world", "seconds", "--robot", "mine.toml"}).code, 0);
  entry("mine", "mouse = \"flood\"");
  fs::remove(folder_ / "mine.toml");
  const Ended added = add("spring", "mine", {"--sandbox", "off"});
  EXPECT_EQ(added.code, 0) << added.err;
}

TEST_F(AnOrganiser, KeepsEntriesOfOtherNamesAndMendsBrokenOnes) {
  ASSERT_EQ(init("spring").code, 0);
  entry("one", "mouse = \"flood\"");
  for (const char* name : {"a b", "a/b"}) {
    file("one/entry.toml", std::string("authors = [\"Ada\"]\nlicence = \"MIT\"\n[[mouse]]\nname = \"") + name +
                               "\"\nmouse = \"flood:stride=1\"\n");
    ASSERT_EQ(add("spring", "one", {"--replace"}).code, 0) << name;
  }
  EXPECT_THAT(content("spring/entries/a_b/entry.toml"), HasSubstr("\"a b\""));
  EXPECT_THAT(content("spring/entries/a_b~2/entry.toml"), HasSubstr("\"a/b\""));
  file("spring/entries/a_b~2/entry.toml", "x");
  EXPECT_EQ(labmouse({"league", "run", "spring", "--sandbox", "off"}).code, 2);
  EXPECT_EQ(add("spring", "one", {"--replace", "--sandbox", "off"}).code, 0);
  for (const auto& left : fs::directory_iterator(folder_ / "spring/entries"))
    EXPECT_THAT(left.path().filename().string(), Not(::testing::StartsWith("."))) << left;
}

TEST_F(AnOrganiser, RefusesAnExaminationInWhichNobodyCanScore) {
  is_refused({"league", "init", "spring", "--world", "seconds", "--practice", "contest-01", "--kind", "prim", "--side",
              "40", "--examination", "2"},
             "examination");
  EXPECT_FALSE(fs::exists(folder_ / "spring/season.toml"));
}

TEST_F(AnOrganiser, KeepsPagesOfOthers) {
  ASSERT_EQ(init("spring").code, 0);
  EXPECT_EQ(fs::status(folder_ / "spring").permissions(), fs::perms::owner_all);
  fs::create_directories(folder_ / "site");
  file("site/index.html", "mine");
  is_refused({"league", "publish", "spring", "-o", "site", "--page", "page.html", "--sandbox", "off"}, "index.html");
  EXPECT_EQ(content("site/index.html"), "mine");
}

TEST_F(AnOrganiser, KeepsThePagesApartFromTheSeed) {
  ASSERT_EQ(init("spring").code, 0);
  fs::create_directory_symlink("spring", folder_ / "link");
  for (const char* site : {"spring", "spring/site", "spring/entries/site", "link", "link/site", "./x/../spring/site"})
    is_refused({"league", "publish", "spring", "-o", site, "--page", "page.html", "--sandbox", "off"}, site);
  EXPECT_FALSE(fs::exists(folder_ / "spring/index.html"));
  const auto published =
      labmouse({"league", "publish", "spring", "-o", "spring-site", "--page", "page.html", "--sandbox", "off"});
  EXPECT_EQ(published.code, 0) << published.err;
}

// Without this, pages would lack replays and nobody would know.
TEST_F(AnOrganiser, RefusesBrokenRecords) {
  ASSERT_EQ(init("spring").code, 0);
  const std::vector<std::string> run = {"league", "run", "spring", "--sandbox", "off"};
  ASSERT_EQ(labmouse(run).code, 0);
  const fs::path record = fs::directory_iterator(folder_ / "spring/records")->path();
  const std::string good = content_of(record), name = "records/" + record.filename().string();
  file("spring/" + name, "{");
  is_refused(run, name);
  fs::remove(record);
  fs::create_directory(record);
  is_refused(run, name);
  fs::remove(record);
  EXPECT_EQ(labmouse(run).code, 0);
  EXPECT_EQ(content_of(record), good);
}

// A pipe may never end.
TEST_F(AnOrganiser, ReadsNoPipes) {
  for (const std::string name : {"secret-seed.txt", "season.toml", "previous-season.json"}) {
    ASSERT_EQ(init("of-" + name).code, 0);
    const fs::path path = folder_ / ("of-" + name) / name;
    fs::remove(path);
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    is_refused({"league", "run", "of-" + name, "--sandbox", "off"}, name);
  }
}

TEST_F(AnOrganiser, DrawsASeedOfTheirOwnEachTime) {
  ASSERT_EQ(labmouse({"league", "init", "one"}).code, 0);
  ASSERT_EQ(labmouse({"league", "init", "two"}).code, 0);
  EXPECT_NE(content("one/secret-seed.txt"), content("two/secret-seed.txt"));
  is_refused({"league", "init", "one"}, "one/season.toml");
}

// The parts run on several machines, one of them twice because it was interrupted; each contest runs once.
TEST_F(AnOrganiser, RunsASeasonInParts) {
  entry("mine", "mouse = \"flood:stride=1\"");
  entry("counted", "capstone = \"robot.py\"",
        follower("        open('" + (folder_ / "contests.log").string() + "', 'a').write('x')\n"));
  const auto publish = [&](const std::string& season) {
    return labmouse(
        {"league", "publish", season, "-o", season + "-site", "--page", "page.html", "--reveal", "--sandbox", "off"});
  };
  for (const char* season : {"whole", "parts"}) {
    ASSERT_EQ(init(season).code, 0);
    for (const char* name : {"mine", "counted"}) ASSERT_EQ(add(season, name, {"--no-check"}).code, 0);
  }
  ASSERT_EQ(publish("whole").code, 0);
  const std::size_t contests = content("contests.log").size();
  EXPECT_EQ(contests, 6U);
  const auto run = [&](const std::string& shard, const std::string& store) {
    return labmouse({"league", "run", "parts", "--sandbox", "off", "--shard", shard, "--store", store});
  };
  for (const char* shard : {"1/3", "2/3", "3/3", "2/3"})
    ASSERT_EQ(run(shard, std::string("part-") + shard[0] + ".db").code, 0) << shard;
  ASSERT_EQ(labmouse({"store", "merge", "part-1.db", "part-2.db", "part-3.db", "-o", "parts/results.db"}).code, 0);
  const Ended published = publish("parts");
  ASSERT_EQ(published.code, 0) << published.err;
  EXPECT_EQ(content("contests.log").size(), 2 * contests);
  for (const char* name : {"index.html", "results.json", "report.html", "examination.html"})
    EXPECT_TRUE(content(std::string("whole-site/") + name) == content(std::string("parts-site/") + name)) << name;
  is_refused({"league", "run", "parts", "--sandbox", "off", "--shard", "1/3"}, "--store");
  is_refused({"league", "run", "parts", "--sandbox", "off", "--shard", "4/3", "--store", "x.db"}, "4/3");
}

// What a season was before is read from its published results alone.
TEST_F(AnOrganiser, ShowsTheSeasonsBefore) {
  file("summer.txt", "dry chalk and 42 lemons\n");
  file("autumn.txt", "no chalk and 43 lemons\n");
  const auto publish = [&](const std::string& season, std::vector<std::string> more) {
    more.insert(more.begin(),
                {"league", "publish", season, "-o", season + "-site", "--page", "page.html", "--sandbox", "off"});
    return labmouse(std::move(more)).code;
  };
  ASSERT_EQ(init("spring", {"--title", "Spring <1>"}).code, 0);
  entry("ada", "mouse = \"flood:stride=1\"");
  entry("ben", "mouse = \"flood:stride=2\"");
  ASSERT_EQ(add("spring", "ada").code, 0);
  ASSERT_EQ(publish("spring", {}), 0);
  is_refused({"league", "init", "summer", "--after", "spring-site", "--seed-file", "summer.txt"}, "--reveal");
  ASSERT_EQ(publish("spring", {"--reveal"}), 0);
  is_refused({"league", "init", "summer", "--after", "spring-site", "--seed-file", "seed.txt"}, "Spring <1>");
  is_refused({"league", "init", "summer", "--after", "nowhere", "--seed-file", "summer.txt"}, "nowhere");
  EXPECT_FALSE(fs::exists(folder_ / "summer/season.toml"));
  ASSERT_EQ(init("summer", {"--title", "Summer", "--after", "spring-site"}, "summer.txt").code, 0);
  ASSERT_EQ(add("summer", "ben").code, 0);
  fs::rename(folder_ / "spring-site", folder_ / "kept");
  ASSERT_EQ(publish("summer", {"--reveal"}), 0);
  const auto spring = nlohmann::json::parse(content("kept/results.json")), summer = results("summer-site");
  ASSERT_EQ(summer.at("earlier_seasons").size(), 1U);
  EXPECT_EQ(of(summer.at("earlier_seasons")[0], "ada").at("rank"), of(spring, "ada").at("rank"));
  EXPECT_EQ(of(summer.at("earlier_seasons")[0], "ada").at("share_of_best"), of(spring, "ada").at("share_of_best"));
  EXPECT_EQ(summer.at("earlier_seasons")[0].at("mice").size(), spring.at("mice").size());
  ASSERT_EQ(init("autumn", {"--after", "summer-site/results.json"}, "autumn.txt").code, 0);
  ASSERT_EQ(publish("autumn", {}), 0);
  const auto autumn = results("autumn-site");
  ASSERT_EQ(autumn.at("earlier_seasons").size(), 2U);
  EXPECT_EQ(autumn.at("earlier_seasons")[0], summer.at("earlier_seasons")[0]);
  EXPECT_EQ(of(autumn.at("earlier_seasons")[1], "ben").at("rank"), of(summer, "ben").at("rank"));
  const std::string page = content("autumn-site/index.html");
  const auto history = page.find("History");
  ASSERT_NE(history, std::string::npos);
  for (const char* text : {"Spring &lt;1&gt;", "Summer", "<th>ada</th>", "<th>ben</th>"})
    EXPECT_NE(page.find(text, history), std::string::npos) << text;
  EXPECT_EQ(content("kept/index.html").find("History"), std::string::npos);
  file("autumn/previous-season.json", "{}");
  EXPECT_EQ(publish("autumn", {}), 2);
}

TEST_F(AnOrganiser, RefusesWhatIsNoEntry) {
  ASSERT_EQ(init("spring").code, 0);
  fs::create_directories(folder_ / "empty");
  is_refused({"league", "add", "spring", "empty", "--sandbox", "off"}, "entry.toml");
  entry("ariadne", "mouse = \"flood\"");
  is_refused({"league", "add", "spring", "ariadne", "--sandbox", "off"}, "ariadne");
  entry("outside", "program = \"python3 ../spy/robot.py\"");
  is_refused({"league", "add", "spring", "outside", "--sandbox", "off"}, "outside/entry.toml:3:1");
  for (const char* name : {"../x", ".x", "/x", "a/../b"}) {
    entry("named", "mouse = \"flood\"");
    file("named/entry.toml", std::string("authors = [\"Ada\"]\nlicence = \"MIT\"\n[[mouse]]\nname = \"") + name +
                                 "\"\nmouse = \"flood\"\n");
    is_refused({"league", "add", "spring", "named", "--sandbox", "off"}, "named/entry.toml:3:1");
  }
  entry("linked", "capstone = \"robot.py\"", crashing);
  fs::create_symlink("/etc/passwd", folder_ / "linked/link");
  is_refused({"league", "add", "spring", "linked", "--sandbox", "off"}, "linked/link");
  entry("broken", "capstone = \"robot.py\"", crashing);
  const Ended refused = add("spring", "broken", {"--sandbox", "off"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "spring/entries/broken"));
  EXPECT_FALSE(fs::exists(folder_ / "spring/entries/.partial"));
}

TEST_F(AnOrganiser, SaysWhereThereIsNoSandbox) {
  ASSERT_EQ(init("spring").code, 0);
  entry("spy", "capstone = \"robot.py\"", spy(folder_));
  ASSERT_EQ(add("spring", "spy", {"--no-check", "--sandbox", "off"}).code, 0);
  ASSERT_EQ(labmouse({"league", "publish", "spring", "-o", "site", "--page", "page.html", "--sandbox", "off"}).code, 0);
  EXPECT_THAT(results("site").at("sandbox"), HasSubstr("without a sandbox"));
  // The control of the test above: the spy does find the files.
  EXPECT_THAT(of(results("site"), "spy").dump(), HasSubstr("forfeit"));
}

}  // namespace
}  // namespace labmouse::test
