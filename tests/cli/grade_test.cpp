// labmouse grade, with a class of students whose programs have the same names in folders of their own.
#include <fcntl.h>
#include <sys/stat.h>

#include <filesystem>
#include <set>

#include "tests/cli/robots_in_python.hpp"
#include "tests/cli/user.hpp"
#include "tests/lab/reports/unpacking.hpp"

namespace labmouse::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* slow =
    "class Robot(object):\n    def __init__(self, dim):\n        pass\n"
    "    def next_move(self, sensors):\n        while True: pass\n";
constexpr const char* babbling =
    "class Robot(object):\n    def __init__(self, dim):\n        pass\n"
    "    def next_move(self, sensors):\n        return 'north', sensors\n";
/// Says to its teacher what it sees, and drives into walls.
constexpr const char* ramming =
    "import sys\nclass Robot(object):\n    def __init__(self, dim):\n        self.steps = 0\n"
    "    def next_move(self, sensors):\n        sys.stderr.write('seen %s\\n' % sensors)\n"
    "        self.steps += 1\n        if self.steps > 5: raise ValueError('tired')\n        return 0, 3\n";
constexpr const char* turning =
    "class Robot(object):\n    def __init__(self, dim):\n        pass\n"
    "    def next_move(self, sensors):\n        return 90, 0\n";
constexpr const char* unreadable = "class Robot(object:\n";

/// A maze with one way, in which whoever follows the right wall arrives.
constexpr const char* spiral =
    "o---o---o---o---o\n|               |\no   o---o---o   o\n|   |     G |   |\no   o   o---o   o\n"
    "|   | G   G |   |\no   o---o   o   o\n| S |           |\no---o---o---o---o\n";

class AGrader : public AUser {
 protected:
  AGrader() {
    file("page.html", small_page);
    std::filesystem::create_directories(folder_ / "course" / "mazes");
    file("course/mazes/spiral.txt", spiral);
    file("course/tasks.toml", tasks);
  }

  /// Adds a student with that robot.py; none without a text.
  void add(const std::string& name, const std::string& robot) {
    std::filesystem::create_directories(folder_ / "course" / name);
    if (!robot.empty()) file("course/" + name + "/robot.py", robot);
    mice_ += "[[mouse]]\nname = \"" + name + "\"\ncapstone = \"" + name + "/robot.py\"\n";
    file("course/class.toml", mice_);
  }

  Ended grade(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"grade", "--mice", "course/class.toml", "--tasks", "course/tasks.toml"});
    return labmouse(std::move(more));
  }
  nlohmann::json grades(std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--format", "json"});
    const Ended ended = grade(std::move(more));
    EXPECT_EQ(ended.code, 0) << ended.err;
    return nlohmann::json::parse(ended.out, nullptr, false);
  }
  static nlohmann::json of(const nlohmann::json& grades, const std::string& student) {
    for (const auto& one : grades.at("students"))
      if (one.at("name") == student) return one;
    ADD_FAILURE() << "no student " << student;
    return {};
  }
  static std::vector<double> points(const nlohmann::json& student) {
    std::vector<double> all;
    for (const auto& task : student.at("tasks")) all.push_back(task.at("points"));
    return all;
  }

  static constexpr const char* tasks =
      "seed = \"quite secret words\"\nlimits = { decision = 0.3, start = 20 }\n"
      "[[task]]\nname = \"finishes the spiral\"\npoints = 5\nmazes = [\"mazes/spiral.txt\"]\nfinish = true\n"
      "[[task]]\nname = \"good in hidden mazes\"\npoints = 8\nhidden = 2\nside = 6\nkind = \"depth-first\"\n"
      "at_most = { ratio = 100 }\nper_maze = true\n"
      "[[task]]\nname = \"never hits a wall\"\npoints = 2\nmazes = [\"mazes/spiral.txt\"]\n"
      "at_most = { known_wall_hits = 0 }\n";

 private:
  std::string mice_;
};

TEST_F(AGrader, GetsPointsForEachTask) {
  add("Anna", follower());
  add("Ben", turning);
  add("Carl", ramming);
  const auto all = grades();
  EXPECT_EQ(all.at("points"), 15.0);
  EXPECT_THAT(points(of(all, "Anna")), testing::ElementsAre(5.0, 8.0, 2.0));
  EXPECT_EQ(of(all, "Anna").at("points"), 15.0);
  EXPECT_THAT(points(of(all, "Ben")), testing::ElementsAre(0.0, 8.0, 2.0));
  EXPECT_THAT(points(of(all, "Carl")), testing::ElementsAre(0.0, 0.0, 0.0));
  EXPECT_THAT(of(all, "Ben").at("tasks")[0].at("lost"), HasSubstr("out of steps"));
  EXPECT_THAT(of(all, "Carl").at("tasks")[2].at("lost"), HasSubstr("forfeit"));
}

TEST_F(AGrader, TakesAFigureOfTheWorldAsALimit) {
  add("Anna", follower());
  const auto limited = [&](const std::string& limit) {
    file("course/tasks.toml",
         "[[task]]\nname = 'a'\npoints = 3\nmazes = ['mazes/spiral.txt']\nat_most = { " + limit + " }\n");
    return points(of(grades(), "Anna"))[0];
  };
  EXPECT_EQ(limited("search_steps = 1000"), 3.0);
  EXPECT_EQ(limited("search_steps = 3"), 0.0);
  EXPECT_EQ(limited("score = 1000"), 3.0);
  EXPECT_EQ(limited("score = 3"), 0.0);
  EXPECT_EQ(limited("ratio = 0.99"), 0.0);
  EXPECT_EQ(limited("blocked_steps = 0"), 3.0);
}

TEST_F(AGrader, GetsATableAndCsv) {
  add("Anna", follower());
  add("Carl, the 2nd", crashing);
  const Ended table = grade();
  EXPECT_EQ(table.code, 0);
  EXPECT_THAT(table.out, testing::ContainsRegex("Anna +5 +8 +2 +15\n"));
  EXPECT_THAT(table.out, testing::ContainsRegex("Carl, the 2nd +0 +0 +0 +0\n"));
  EXPECT_THAT(table.out, testing::ContainsRegex("\n +2 +good in hidden mazes \\(8\\)\n"));
  const Ended csv = grade({"--format", "csv"});
  EXPECT_EQ(csv.out,
            "student,finishes the spiral,good in hidden mazes,never hits a wall,points\n"
            "Anna,5,8,2,15\n\"Carl, the 2nd\",0,0,0,0\n");
}

TEST_F(AGrader, GetsZeroAndTheReasonForEachBrokenProgram) {
  add("crashing", crashing);
  add("slow", slow);
  add("babbling", babbling);
  add("unreadable", unreadable);
  add("absent", "");
  add("Anna", follower());
  const auto all = grades();
  for (const auto& student : all.at("students")) {
    if (student.at("name") == "Anna") continue;
    EXPECT_EQ(student.at("points"), 0.0) << student.dump();
    for (const auto& task : student.at("tasks")) EXPECT_NE(task.at("lost"), "") << student.dump();
  }
  EXPECT_EQ(of(all, "Anna").at("points"), 15.0);
  EXPECT_THAT(of(all, "crashing").at("broken"), HasSubstr("robot.py"));
  EXPECT_THAT(of(all, "crashing").dump(), HasSubstr("no way in"));
  EXPECT_THAT(of(all, "slow").at("tasks")[0].at("lost"), HasSubstr("late"));
  EXPECT_THAT(of(all, "babbling").at("tasks")[0].at("lost"), HasSubstr("forfeit"));
  EXPECT_THAT(of(all, "unreadable").dump(), HasSubstr("SyntaxError"));
  EXPECT_THAT(of(all, "absent").at("broken"), HasSubstr("robot.py"));
}

TEST_F(AGrader, GivesUpAProgramThatDoesNotStart) {
  add("asleep", "import time\ntime.sleep(1000)\n");
  std::string hasty = tasks;
  hasty.replace(hasty.find("start = 20"), 10, "start = 0.5");
  file("course/tasks.toml", hasty);
  const auto student = of(grades(), "asleep");
  const auto tasks_of = student.at("tasks");
  EXPECT_EQ(tasks_of[0].at("contests")[0].at("outcome"), "forfeit: hung");
  for (const auto& contest : tasks_of[1].at("contests")) EXPECT_EQ(contest.at("outcome"), "not run");
}

TEST_F(AGrader, GetsTheSameBytesWithAnyNumberOfThreads) {
  add("Anna", follower());
  add("Ben", turning);
  add("Carl", crashing);
  add("Dora", ramming);
  const auto files = [&](const std::string& folder, const std::string& jobs) {
    const Ended ended = grade({"--jobs", jobs, "--format", "json", "--junit", folder + "/junit.xml", "--gradescope",
                               folder + "/gradescope", "--feedback", folder + "/feedback", "--page", "page.html"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    std::map<std::string, std::string> all = {{"out", ended.out}};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / folder))
      if (entry.is_regular_file())
        all[std::filesystem::relative(entry.path(), folder_ / folder).string()] = content_of(entry.path());
    return all;
  };
  const auto first = files("one", "1");
  EXPECT_EQ(first.size(), 10U);
  EXPECT_EQ(files("two", "4"), first);
  // An option replaces its own files.
  EXPECT_EQ(files("one", "2"), first);
}

TEST_F(AGrader, GetsHiddenMazesByTheSecretSeedAlone) {
  add("Anna", follower());
  const std::string tasks_of = tasks;
  const auto graded = [&](const std::string& seed) {
    file("course/tasks.toml", tasks_of.substr(tasks_of.find('\n') + 1));
    file("seed.txt", seed + "\n");
    return grades({"--seed-file", "seed.txt"}).at("students");
  };
  const auto with_secret = graded("quite secret words");
  EXPECT_NE(graded("other secret words"), with_secret);
  file("course/tasks.toml", tasks);
  EXPECT_EQ(grades().at("students"), with_secret);
  EXPECT_EQ(grade({"--seed-file", "seed.txt"}).code, 2);
  file("course/tasks.toml", tasks_of.substr(tasks_of.find('\n') + 1));
  for (const char* guessed : {"", "wet chalk\n"}) {
    file("seed.txt", guessed);
    is_refused({"grade", "--mice", "course/class.toml", "--tasks", "course/tasks.toml", "--seed-file", "seed.txt"},
               "seed.txt");
  }
  is_refused({"grade", "--mice", "course/class.toml", "--tasks", "course/tasks.toml"},
             "course/tasks.toml:7:1: error: ", "seed");
}

TEST_F(AGrader, WritesNothingOfHiddenMazesForStudents) {
  add("Anna", follower());
  add("Carl", ramming);
  const auto everything = [&] {
    const Ended ended =
        grade({"--junit", "junit.xml", "--gradescope", "gradescope", "--feedback", "feedback", "--page", "page.html"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    std::string text = ended.out + content("junit.xml");
    for (const std::string name : {"Anna", "Carl"}) {
      text += content("gradescope/" + name + "/results.json");
      const std::string page = content("feedback/" + name + ".html");
      text += page + block_of(page, "labmouse-report").dump() + block_of(page, "labmouse-records").dump();
    }
    return text;
  };
  const std::string text = everything();
  EXPECT_THAT(text, Not(HasSubstr("secret")));
  EXPECT_THAT(text, HasSubstr("hidden 1"));
  const auto page = content("feedback/Anna.html");
  EXPECT_THAT(block_of(page, "labmouse-report").at("mazes").dump(), Not(HasSubstr("hidden")));
  EXPECT_THAT(block_of(page, "labmouse-report").dump(), HasSubstr("spiral"));
  EXPECT_EQ(block_of(page, "labmouse-records").at("records").size(), 1U);
  // What a program prints in a maze that its student knows is shown, and no more of it.
  EXPECT_THAT(content("gradescope/Carl/results.json"), HasSubstr("seen "));
  const auto tests = nlohmann::json::parse(content("gradescope/Carl/results.json")).at("tests");
  EXPECT_THAT(tests[1].at("output"), testing::AllOf(HasSubstr("hidden 1"), Not(HasSubstr("seen "))));

  file("course/tasks.toml", std::string("show_hidden = true\n") + tasks);
  EXPECT_THAT(everything(), Not(HasSubstr("secret")));
  EXPECT_THAT(block_of(content("feedback/Anna.html"), "labmouse-report").at("mazes").dump(), HasSubstr("hidden 1"));
  EXPECT_EQ(block_of(content("feedback/Anna.html"), "labmouse-records").at("records").size(), 3U);
}

// They would tell students something of hidden mazes, in which they may be graded again.
TEST_F(AGrader, WritesNoScoresOfHiddenMazesForStudents) {
  add("Anna", follower());
  const std::string hidden = "points = 1\nhidden = 2\nside = 6\nkind = 'depth-first'\nat_most = { ratio = 0.5 }\n";
  const std::string of_hidden =
      "seed = 5\n[[task]]\nname = 'each'\nper_maze = true\n" + hidden + "[[task]]\nname = 'mean'\n" + hidden;
  const auto texts = [&] {
    const Ended ended = grade({"--junit", "junit.xml", "--gradescope", "gradescope", "--feedback", "feedback", "--page",
                               "page.html", "--format", "json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("is above 0.5"));
    const std::string page = content("feedback/Anna.html");
    return std::vector<std::string>{
        content("junit.xml"), content("gradescope/Anna/results.json"),
        page.substr(page.find("<details"), page.find("</details>") - page.find("<details"))};
  };
  file("course/tasks.toml", of_hidden);
  for (const std::string& text : texts()) {
    EXPECT_THAT(text, HasSubstr("2 of 2"));
    EXPECT_THAT(text, Not(HasSubstr("ratio")));
    EXPECT_THAT(text, Not(HasSubstr("above")));
    EXPECT_THAT(text, Not(testing::ContainsRegex("[0-9]\\.[0-9][0-9][0-9]"))) << "a score";
  }
  file("course/tasks.toml", "show_hidden = true\n" + of_hidden);
  for (const std::string& text : texts()) EXPECT_THAT(text, HasSubstr("is above 0.5"));
}

TEST_F(AGrader, WritesNothingWhenStoppedWhilePlanning) {
  add("Anna", follower());
  file("course/tasks.toml", std::string(tasks).substr(std::string(tasks).find('\n') + 1));
  const std::string pipe = (folder_ / "seed").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const auto files = [&] {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
      if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.'))
        names.insert(entry.path().string());
    return names;
  };
  const auto before = files();
  const Program program(folder_, {"grade", "--mice", "course/class.toml", "--tasks", "course/tasks.toml", "--seed-file",
                                  "seed", "--junit", "grades/junit.xml", "--gradescope", "grades/gradescope",
                                  "--feedback", "grades/feedback", "--page", "page.html"});
  // Once the pipe has a reader, the program waits for the end of the seed.
  int end = -1;
  ASSERT_TRUE(patiently([&] { return (end = open(pipe.c_str(), O_WRONLY | O_NONBLOCK)) >= 0; }));
  program.interrupt();
  EXPECT_EQ(program.wait().code, -SIGINT);
  close(end);
  EXPECT_EQ(files(), before);
}

TEST_F(AGrader, WritesResultsForGradescope) {
  add("Anna", follower());
  add("Carl", crashing);
  EXPECT_EQ(grade({"--gradescope", "gradescope"}).code, 0);
  const auto anna = nlohmann::json::parse(content("gradescope/Anna/results.json"));
  EXPECT_EQ(anna.at("score"), 15.0);
  ASSERT_EQ(anna.at("tests").size(), 3U);
  EXPECT_EQ(anna.at("tests")[1].at("name"), "good in hidden mazes");
  EXPECT_EQ(anna.at("tests")[1].at("score"), 8.0);
  EXPECT_EQ(anna.at("tests")[1].at("max_score"), 8.0);
  EXPECT_EQ(anna.at("tests")[1].at("visibility"), "visible");
  const auto carl = nlohmann::json::parse(content("gradescope/Carl/results.json"));
  EXPECT_EQ(carl.at("score"), 0.0);
  EXPECT_THAT(carl.at("output"), HasSubstr("robot.py"));
  EXPECT_EQ(carl.at("tests")[0].at("status"), "failed");
  // A file of another kind is kept.
  file("gradescope/Carl/results.json", "{}");
  is_refused({"grade", "--mice", "course/class.toml", "--tasks", "course/tasks.toml", "--gradescope", "gradescope"},
             "gradescope/Carl/results.json: error: ", "--gradescope");
}

TEST_F(AGrader, WritesJUnitForABuildServer) {
  add("Anna", follower());
  add("B <&> B", turning);
  EXPECT_EQ(grade({"--junit", "junit.xml"}).code, 0);
  const std::string xml = content("junit.xml");
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"Anna\" tests=\"3\" failures=\"0\" skipped=\"0\">"));
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"B &lt;&amp;&gt; B\" tests=\"3\" failures=\"1\" skipped=\"0\">"));
  EXPECT_THAT(xml, HasSubstr("name=\"finishes the spiral\"><failure message=\"0 of 5 points"));
}

TEST_F(AGrader, WritesAPageForEachStudentWithNothingOfOthers) {
  // Base64 has no "-", so that no name stands in packed records by chance.
  const std::vector<std::string> names = {"Anna-A", "Ben-B", "Carl-C"};
  add("Anna-A", follower());
  add("Ben-B", turning);
  add("Carl-C", crashing);
  EXPECT_EQ(grade({"--feedback", "feedback", "--page", "page.html"}).code, 0);
  for (const std::string& name : names) {
    const std::string page = content("feedback/" + name + ".html");
    const std::string all = page + block_of(page, "labmouse-report").dump() + block_of(page, "labmouse-records").dump();
    for (const std::string& other : names)
      if (other == name)
        EXPECT_THAT(all, HasSubstr(other));
      else
        EXPECT_THAT(all, Not(HasSubstr(other)));
  }
  const std::string ben = content("feedback/Ben-B.html");
  EXPECT_THAT(ben, HasSubstr("<h1>Ben-B: 10 of 15 points</h1>"));
  EXPECT_THAT(ben, HasSubstr("out of steps"));
  EXPECT_THAT(content("feedback/Carl-C.html"), HasSubstr("no way in"));
}

TEST_F(AGrader, GradesAClassOfThirtyWithBrokenPrograms) {
  file("course/tasks.toml",
       "seed = 5\nlimits = { decision = 0.2, start = 20 }\n"
       "[[task]]\nname = \"arrives\"\npoints = 1\nmazes = [\"mazes/spiral.txt\"]\nfinish = true\n"
       "[[task]]\nname = \"arrives in a hidden maze\"\npoints = 1\nhidden = 1\nside = 6\nkind = \"depth-first\"\n"
       "finish = true\n");
  const std::array<std::string, 6> kinds = {follower(), crashing, turning, slow, follower(), babbling};
  for (std::size_t i = 0; i < 30; ++i) add("student" + std::to_string(i + 1), kinds[i % kinds.size()]);
  const auto all = grades();
  ASSERT_EQ(all.at("students").size(), 30U);
  for (std::size_t i = 0; i < 30; ++i) {
    const auto& student = all.at("students")[i];
    EXPECT_EQ(student.at("name"), "student" + std::to_string(i + 1));
    EXPECT_EQ(student.at("points"), kinds[i % kinds.size()] == follower() ? 2.0 : 0.0) << student.dump();
  }
}

TEST_F(AGrader, IsToldWhatIsWrong) {
  add("Anna", follower());
  const std::vector<std::string> words = {"grade", "--mice", "course/class.toml", "--tasks", "course/tasks.toml"};
  const auto refused = [&](const std::string& tasks_of, auto... parts) {
    file("course/tasks.toml", tasks_of);
    is_refused(words, parts...);
  };
  const std::string task = "[[task]]\nname = 'a'\npoints = 1\nfinish = true\n";
  refused("sead = 1\n" + task + "mazes = ['capstone-1']\n", "course/tasks.toml:1:1: error: ", "'seed'");
  refused(task + "mazes = ['no.txt']\n", "no.txt: error: ", "'a'");
  refused(task + "mazes = ['mazes/*.maz']\n", "mazes/*.maz: error: ");
  file("course/closed.txt", "o---o---o\n| S | G |\no---o---o\n");
  refused(task + "mazes = ['closed.txt']\n", "course/tasks.toml:1:1: error: ", "closed.txt", "score");
  refused("world = 'physical'\nsettings = { robot = 'no.toml' }\n" + task + "mazes = ['capstone-1']\n",
          "course/tasks.toml: ", "no.toml: error: ");
  is_refused({"grade", "--tasks", "course/tasks.toml"}, "--mice");
  is_refused({"grade", "--mice", "no.toml", "--tasks", "course/tasks.toml"}, "no.toml: error: ");
  file("course/tasks.toml", task + "mazes = ['capstone-1']\n");
  file("course/class.toml", "[[mouse]]\nname = 'a'\nrobot = 'x'\n");
  EXPECT_EQ(labmouse(words).code, 2);
}

TEST_F(AGrader, GradesOtherWorlds) {
  file("course/class.toml",
       "[[mouse]]\nname = 'quick'\nmouse = 'flood-return'\n[[mouse]]\nname = 'foreign'\nmms = 'false'\n"
       "[[mouse]]\nname = 'walking'\ncontroller = 'false'\n");
  file("course/tasks.toml",
       "world = 'seconds'\nsettings = { robot = 'classic' }\n"
       "[[task]]\nname = 'a'\npoints = 1\nmazes = ['contest-01']\nfinish = true\n");
  const auto all = grades();
  EXPECT_EQ(of(all, "quick").at("points"), 1.0);
  EXPECT_EQ(of(all, "walking").at("points"), 0.0);
  EXPECT_THAT(of(all, "walking").at("broken"), HasSubstr("walking"));
}

}  // namespace
}  // namespace labmouse::test
