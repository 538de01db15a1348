// Pipes in place of files, and files that cannot be written.
#include "tests/cli/user.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::corridor;
using test::Ended;
using test::Says;
using ::testing::HasSubstr;

/// A user of a shell.
class AShellUser : public test::AUser {
 protected:
  /// Runs a line of bash in which `labmouse` is the program.
  Ended shell(const std::string& line) const {
    file(".line", "labmouse() { '" LABMOUSE_PROGRAM "' \"$@\"; }\n" + line + "\n");
    const int status = std::system(("cd '" + folder_.string() + "' && bash .line > .out 2> .err").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), content(".out"), content(".err")};
  }
  /// The line prints just that and ends well.
  void prints(const std::string& line, const std::string& text) const {
    const Ended ended = shell(line);
    EXPECT_EQ(ended.code, 0) << line;
    EXPECT_EQ(ended.out, text) << line << "\n" << ended.err;
  }
};

TEST_F(AShellUser, PipesAMazeIn) {
  const std::string maze = file("corridor.txt", corridor);
  const std::string shown = labmouse({"show", maze}).out;
  for (const char* path : {"-", "/dev/stdin", "/dev/fd/0"})
    prints("cat corridor.txt | labmouse convert " + std::string(path) + " -", corridor);
  prints("labmouse convert - /dev/stdout < corridor.txt", corridor);
  prints("labmouse convert <(cat corridor.txt) -", corridor);
  prints("labmouse race --mice flood --mazes - --format csv < corridor.txt | cut -d, -f1-2 | tail -n 1", "flood,-\n");
}

TEST_F(AShellUser, CompilesTheArraysOfARobot) {
  for (const char* names : {"plain", "ukmars", "kerikun11"})
    prints("labmouse robot show classic --c " + std::string(names) +
               " > robot.h && cc -std=c99 -Wall -Wextra -Wno-unused-variable -Werror -fsyntax-only -x c robot.h",
           "");
  is_refused({"robot", "show", "mm2021", "--c", "plain"}, "mm2021", "times of turns");
  is_refused({"robot", "show", "--c", "plane"}, "plain");
  is_refused({"robot", "show", "--c", "plain", "--svg", "robot.svg"}, "--c", "--svg");
}

TEST_F(AShellUser, PipesRecordsOn) {
  file("corridor.txt", corridor);
  const std::string score = shell("labmouse run flood corridor.txt | tail -n 1").out;
  prints("labmouse run flood corridor.txt --record - 2> /dev/null | labmouse score -", score);
  prints("labmouse run flood corridor.txt --record /dev/stdout 2> summary | labmouse score /dev/stdin", score);
  EXPECT_THAT(content("summary"), HasSubstr(score));
  prints("labmouse run flood corridor.txt --record >(labmouse score - > told) > /dev/null; wait $!; cat told", score);
  prints("labmouse run flood corridor.txt --record walk.jsonl > /dev/null; labmouse replay - < walk.jsonl | tail -n 1",
         score);
  prints("labmouse show --record - --svg - < walk.jsonl | head -c 4", "<svg");
}

TEST_F(AShellUser, PipesResultsOn) {
  file("corridor.txt", corridor);
  const Ended compared = shell(
      "labmouse race --mice flood --mazes corridor.txt --format json |"
      "labmouse race --mice flood --mazes corridor.txt --baseline - | tail -n 1");
  EXPECT_THAT(compared.out, HasSubstr("flood")) << compared.err;
  prints("labmouse sweep flood --vary stride=1,2 --mazes corridor.txt --csv - 2> /dev/null | wc -l", "3\n");
  prints(
      "labmouse study --mice flood,random --mazes corridor.txt corridor.txt island-8 --folds 2 --csv - 2> table |"
      "grep -c corridor.txt",
      "1\n");
  EXPECT_NE(content("table"), "");
}

TEST_F(AShellUser, PipesTheLogOfASearchOnce) {
  file("corridor.txt", corridor);
  const std::string tune = "labmouse tune visit-counter --params coverage --mazes corridor.txt --evaluations 12 ";
  ASSERT_EQ(shell(tune + "--log tune.csv").code, 0);
  prints(tune + "--log - 2> /dev/null", content("tune.csv"));
  prints(tune + "--log >(cat > told) > /dev/null; wait $!; cat told", content("tune.csv"));
}

TEST_F(AShellUser, PipesWhatMiceAreMadeOf) {
  file("corridor.txt", corridor);
  const std::string robots = "labmouse route corridor.txt --robot ", rules = "labmouse rules show ";
  prints(robots + "- < '" LABMOUSE_SOURCE_DIR "/robots/half.toml' | tail -n 1",
         shell(robots + "'" LABMOUSE_SOURCE_DIR "/robots/half.toml' | tail -n 1").out);
  prints("labmouse rules show uk | labmouse rules show - | head -n 5", shell("labmouse rules show uk | head -n 5").out);
  EXPECT_EQ(shell("labmouse learn corridor.txt -o - 2> /dev/null |"
                  "labmouse race --mice ariadne:prior=- --mazes corridor.txt")
                .code,
            0);
  // Each value makes a mouse, and each mouse asks for the prior.
  EXPECT_EQ(shell("labmouse learn corridor.txt -o - 2> /dev/null |"
                  "labmouse sweep ariadne:prior=- --vary travel=20,30 --mazes corridor.txt")
                .code,
            0);
}

TEST_F(AShellUser, CannotHaveTwoFilesInOnePlace) {
  file("corridor.txt", corridor);
  is_refused({"run", "flood", "corridor.txt", "--record", "-", "--svg", "/dev/stdout"}, "--record", "--svg");
  is_refused({"sweep", "flood", "--vary", "stride=1,2", "--csv", "a", "--svg", "a"}, "--csv", "--svg");
}

TEST_F(AShellUser, NeedsNoMemoryForTheJsonOfAllContests) {
  if (test::sanitized) GTEST_SKIP() << "sanitizers need all addresses that there are";
  file("corridor.txt", corridor);
  // The contests fit into this; as one JSON they would need twice as much.
  const std::string race = "ulimit -v 110000; ulimit -c 0; labmouse race --mice random --mazes corridor.txt --jobs 1 ";
  const Ended many = shell(race + "--runs 50000 --format json");
  EXPECT_EQ(many.code, 0) << many.err;
  EXPECT_EQ(many.out.substr(many.out.size() - 2), "}\n");
  EXPECT_GT(many.out.size(), std::size_t{10'000'000});
  const Ended too_many = shell(race + "--runs 1000000");
  EXPECT_EQ(too_many.code, 2);
  EXPECT_EQ(std::count(too_many.err.begin(), too_many.err.end(), '\n'), 1);
  EXPECT_THAT(too_many.err, Says("error: ", "memory", "--runs", "ulimit -v"));
}

TEST_F(AShellUser, CannotNameOneFileInTwoWays) {
  file("corridor.txt", corridor);
  std::filesystem::create_directory(folder_ / "in");
  std::filesystem::create_symlink("x", folder_ / "link");
  const std::string whole = (folder_ / "x").string();
  for (const std::string& other : {std::string("./x"), std::string("in/../x"), std::string("link"), whole})
    is_refused({"run", "flood", "corridor.txt", "--record", "x", "--svg", other}, "--record", "--svg");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x"));
  is_refused({"tune", "flood", "--params", "stride", "--evaluations", "12", "--log", "a", "--svg", "./a"}, "--log",
             "--svg");
  is_refused({"study", "--mice", "flood", "--csv", "a", "--store", "./a"}, "--csv", "--store");
  is_refused({"race", "--mice", "flood", "--curves", "a", "--store", "./a"}, "--curves", "--store");
  is_refused({"race", "--mice", "flood", "--out", "a", "--store", "a/results.json"}, "--store", "--out");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a"));
}

TEST_F(AShellUser, KeepsFilesOfOtherKinds) {
  file("corridor.txt", corridor);
  labmouse({"run", "flood", "corridor.txt", "--record", "walk.jsonl"});
  const std::string record = content("walk.jsonl");
  std::filesystem::create_hard_link(folder_ / "walk.jsonl", folder_ / "same");
  std::filesystem::create_hard_link(folder_ / "corridor.txt", folder_ / "same.txt");
  is_refused({"show", "--record", "walk.jsonl", "--svg", "./walk.jsonl"}, "walk.jsonl: error: this", "--svg");
  is_refused({"replay", "walk.jsonl", "--svg", "same"}, "same: error: this", "--svg");
  is_refused({"replay", "walk.jsonl", "--maze", "corridor.txt", "--log", "corridor.txt"}, "corridor.txt: error: this",
             "--log");
  is_refused({"show", "corridor.txt", "--svg", "./corridor.txt"}, "corridor.txt: error: this", "--svg");
  is_refused({"run", "flood", "corridor.txt", "--record", "corridor.txt"}, "corridor.txt: error: this", "--record");
  is_refused({"route", "corridor.txt", "--svg", "corridor.txt"}, "corridor.txt: error: this", "--svg");
  is_refused({"learn", "corridor.txt", "--out", "corridor.txt"}, "corridor.txt: error: this", "--out");
  is_refused({"mms", "true", "corridor.txt", "--record", "corridor.txt"}, "corridor.txt: error: this", "--record");
  is_refused({"race", "--mazes", "corridor.txt", "--junit", "corridor.txt"}, "corridor.txt: error: this", "--junit");
  is_refused({"study", "--mice", "flood,certify", "--mazes", "corridor.txt", "--csv", "corridor.txt"},
             "corridor.txt: error: this", "--csv");
  is_refused({"sweep", "flood", "--vary", "stride=1,2", "--mazes", "corridor.txt", "--csv", "corridor.txt"},
             "corridor.txt: error: this", "--csv");
  is_refused({"tune", "flood", "--params", "stride", "--evaluations", "9", "--log", "corridor.txt"},
             "corridor.txt: error: this", "--log");
  is_refused({"failure-rates", "--mazes", "corridor.txt", "--save", "corridor.txt"}, "corridor.txt: error: this",
             "--save");
  is_refused({"drive", "--mazes", "corridor.txt", "--runs", "1", "--log", "corridor.txt"}, "corridor.txt: error: this",
             "--log");
  is_refused({"convert", "corridor.txt", "walk.jsonl", "--format", "drawing"}, "walk.jsonl: error: this", "OUT");
  for (const char* read : {"corr*.txt", "./corridor.txt", "same.txt"})
    is_refused({"convert", read, "corridor.txt", "--transpose"}, "corridor.txt: error: IN", "OUT");
  EXPECT_EQ(shell("labmouse convert - corridor.txt --transpose < corridor.txt").code, 2);
  is_refused({"make", "contest", "--out", "walk.jsonl", "--format", "drawing"}, "walk.jsonl: error: this", "--out");
  // A program with a maze in it, results of a race that a browser saved, and what cannot be read.
  labmouse({"convert", "contest-01", "maze.c"});
  file("mouse.c", content("maze.c") + "int main(void) { return 0; }\n");
  is_refused({"make", "contest", "--out", "mouse.c"}, "mouse.c: error: this", "--out");
  file("race.json", R"({"labmouse":"0.2.0","seed":1,"groups":[]})");
  is_refused({"run", "flood", "corridor.txt", "--record", "race.json"}, "race.json: error: this", "--record");
  file("real.csv", "time,left,right,gyro\n0,0,0,0\n");
  is_refused({"drive", "--mazes", "corridor.txt", "--runs", "1", "--log", "real.csv"}, "real.csv: error: this",
             "--log");
  file("pom.xml", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<project/>\n");
  is_refused({"race", "--mazes", "corridor.txt", "--junit", "pom.xml"}, "pom.xml: error: this", "--junit");
  // Whatever names the file: a pattern, standard input, a folder, a mouse.
  is_refused({"route", "corr*.txt", "--svg", "corridor.txt"}, "corridor.txt: error: this", "--svg");
  EXPECT_EQ(shell("labmouse show - --svg corridor.txt < corridor.txt").code, 2);
  labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--out", "results"});
  const std::string results = content("results/results.json");
  file("page.html", "<!doctype html><title>labmouse</title><!-- labmouse:report -->\n");
  is_refused({"report", "results", "--page", "page.html", "--out", "results/results.json"}, "results.json: error: this",
             "--out");
  file("mouse.py", "mouse");
  for (const char* mouse : {"program:python3 mouse.py", "program:python3 -m mouse"})
    is_refused({"run", mouse, "corridor.txt", "--record", "mouse.py"}, "mouse.py: error: this", "--record");
  file("values.csv.partial", corridor);
  is_refused({"sweep", "flood", "--vary", "stride=1,2", "--csv", "values.csv"}, "values.csv.partial: error: this",
             "--csv");
  is_refused({"sweep", "flood", "--vary", "stride=1,2", "--csv", "values.csv", "--svg", "values.csv.partial"}, "--csv",
             "--svg");
  EXPECT_EQ(content("walk.jsonl"), record);
  EXPECT_EQ(content("corridor.txt"), corridor);
  EXPECT_EQ(content("results/results.json"), results);
  EXPECT_EQ(content("mouse.py"), "mouse");
  // What a command has written, it replaces.
  const std::vector<std::vector<std::string>> commands = {
      {"run", "flood", "corridor.txt", "--world", "physical", "--record", "a.jsonl", "--svg", "a.svg", "--log",
       "a.csv"},
      {"mms", "true", "corridor.txt", "--record", "a.jsonl"},
      {"replay", "walk.jsonl", "--svg", "a.svg"},
      {"show", "corridor.txt", "--svg", "a.svg"},
      {"robot", "show", "beginner", "--svg", "a.svg"},
      {"route", "contest-01", "--svg", "a.svg"},
      {"drive", "--mazes", "corridor.txt", "--runs", "1", "--log", "a.csv"},
      {"learn", "corridor.txt", "--out", "a.prior"},
      {"failure-rates", "--mazes", "corridor.txt", "--runs", "1", "--save", "a.json"},
      {"race", "--mice", "flood", "--mazes", "corridor.txt", "--fail-above", "99", "--junit", "a.xml"},
      {"race", "--mice", "flood", "--mazes", "corridor.txt", "--world", "failures", "--variation", "0,1", "--curves",
       "a.svg"},
      {"study", "--mice", "flood,certify", "--mazes", "contest-01", "contest-02", "--folds", "2", "--csv", "b.csv",
       "--svg", "a.svg"},
      {"sweep", "flood", "--vary", "stride=1,2", "--mazes", "corridor.txt", "--csv", "c.csv", "--svg", "a.svg"},
      {"tune", "flood", "--params", "stride", "--evaluations", "8", "--mazes", "corridor.txt", "--log", "d.csv",
       "--svg", "a.svg"},
      {"page", "--page", "page.html", "--out", "a.html"},
      {"report", "results", "--page", "page.html", "--out", "a.html"},
      {"convert", "contest-01", "a.maz"},
      {"make", "contest", "--out", "a.txt"}};
  for (const auto& command : commands)
    for (int time = 0; time < 2; ++time) {
      const Ended ended = labmouse(command);
      EXPECT_LT(ended.code, 2) << command.front() << ": " << ended.err;
    }
}

TEST_F(AShellUser, ReplacesNoPipeAndNoDevice) {
  file("corridor.txt", corridor);
  prints("mkfifo pipe; cat pipe > told & labmouse convert corridor.txt pipe; wait; cat told", corridor);
  EXPECT_TRUE(std::filesystem::is_fifo(folder_ / "pipe"));
}

TEST_F(AShellUser, IsToldWhyAFileCannotBeWritten) {
  file("corridor.txt", corridor);
  file("kept.svg", "<svg>kept");
  is_refused({"convert", "corridor.txt", "/dev/full"}, "/dev/full: error: ", "no space");
  const Ended limited = shell("ulimit -f 1; labmouse show contest-01 --svg kept.svg");
  EXPECT_EQ(limited.code, 2);
  EXPECT_THAT(limited.err, HasSubstr("ulimit"));
  EXPECT_EQ(content("kept.svg"), "<svg>kept");
  const Ended tuned = shell(
      "ulimit -f 1; labmouse tune visit-counter --params coverage --mazes corridor.txt --evaluations 1000000 "
      "--log kept.csv | tail -c 400");
  EXPECT_THAT(tuned.err, Says("kept.csv: error: ", "ulimit"));
  EXPECT_THAT(content("kept.csv"), HasSubstr("\n"));  // as of an earlier generation, and whole
  EXPECT_EQ(content("kept.csv").back(), '\n');
  const Ended printed = shell("ulimit -f 1; labmouse show contest-01 --svg - > new.svg");
  EXPECT_EQ(printed.code, 2);
  EXPECT_THAT(printed.err, HasSubstr("ulimit"));
  EXPECT_THAT(shell("labmouse mice > /dev/full").err, Says("standard output", "no space"));
  EXPECT_EQ(shell("ls -A | grep part").out, "");
}

}  // namespace
}  // namespace labmouse
