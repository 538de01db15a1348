// Paths and names that lead nowhere, and what they say.
#include <thread>

#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using test::corridor;
using test::Ended;
using ::testing::HasSubstr;
using ::testing::Not;

class APathfinder : public test::AUser {
 protected:
  APathfinder() { file("corridor.txt", corridor); }

  Ended race_into(const std::string& folder, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"race", "--mazes", "corridor.txt", "--out", folder});
    return labmouse(std::move(more));
  }
};

TEST_F(APathfinder, IsToldOfEmptyPaths) {
  is_refused({"race", "--mice", "flood", "--out", ""}, "--out", "empty");
  is_refused({"race", "--mice", "flood", "--out="}, "--out");
  is_refused({"race", "--mice", "flood", "--baseline", ""}, "--baseline", "empty");
  is_refused({"race", "--mice", "flood", "--mazes", "corridor.txt", ""}, "--mazes", "empty");
  is_refused({"run", "flood", ""}, " maze: ", "empty");
  is_refused({"run", "flood", "corridor.txt", "--svg", ""}, "--svg", "empty");
  is_refused({"run", "flood", "corridor.txt", "--record", ""}, "--record", "empty");
  is_refused({"show", "--record", ""}, "--record", "empty");
  is_refused({"replay", ""}, " file: ", "empty");
  is_refused({"make", "prim", "-o", ""}, "--out", "empty");
  is_refused({"convert", "corridor.txt", ""}, " out: ", "empty");
  is_refused({"report", "", "-o", "a.html"}, " results: ", "empty");
  is_refused({"robot", "show", ""}, " robot: ", "empty");
  is_refused({"tune", "flood", "--params", "stride", "--evaluations", "4", "--log", ""}, "--log", "empty");
}

TEST_F(APathfinder, KeepsTheResultsOfAnEarlierRace) {
  for (const char* world : {"steps", "seconds"}) {
    EXPECT_EQ(race_into(world, {"--world", world, "--mice", "flood"}).code, 0);
    const std::string before = content(std::string(world) + "/results.json");
    const Ended refused = race_into(world, {"--world", world, "--mice", "certify"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("--overwrite"));
    EXPECT_EQ(refused.out, "");
    EXPECT_EQ(content(std::string(world) + "/results.json"), before);
    EXPECT_EQ(race_into(world, {"--world", world, "--mice", "certify", "--overwrite"}).code, 0);
    EXPECT_THAT(content(std::string(world) + "/results.json"), HasSubstr("certify"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / world / "flood"));
  }
  EXPECT_EQ(race_into("mms", {"--mice", "mms:true"}).code, 0);
  EXPECT_EQ(race_into("mms", {"--mice", "mms:true"}).code, 2);
}

TEST_F(APathfinder, KeepsTheResultsOfAnEarlierRaceWhereTheNextCannotBeHeld) {
  EXPECT_EQ(race_into("out", {"--mice", "flood"}).code, 0);
  const std::string before = content("out/results.json");
  EXPECT_EQ(race_into("out", {"--mice", "flod", "--overwrite"}).code, 2);
  EXPECT_EQ(race_into("out", {"--world", "seconds", "--mice", "random", "--overwrite"}).code, 2);
  EXPECT_EQ(race_into("out", {"--world", "seconds", "--rules", "./none", "--overwrite"}).code, 2);
  EXPECT_EQ(content("out/results.json"), before);
  is_refused({"race", "--overwrite"}, "--out");
}

TEST_F(APathfinder, NeverSeesTwoRacesInOneFolder) {
  const test::Program first(folder_, {"race", "--mice", "random", "--runs", "500000", "--jobs", "1", "--mazes",
                                      "corridor.txt", "--out", "out"});
  while (!std::filesystem::exists(folder_ / "out" / "random") && first.runs()) std::this_thread::yield();
  std::filesystem::create_directories(folder_ / "elsewhere");
  const Ended second = test::Program(folder_ / "elsewhere", {"race", "--mice", "flood", "--mazes", "../corridor.txt",
                                                             "--out", "../out", "--overwrite"})
                           .wait();
  EXPECT_EQ(second.code, 2);
  EXPECT_THAT(second.err, HasSubstr("another race"));
  first.kill();
  (void)first.wait();
  EXPECT_EQ(race_into("out", {"--mice", "flood", "--overwrite"}).code, 0);
  // What it was just writing may be left of it, but no record.
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder_ / "out"))
    EXPECT_FALSE(file.path().parent_path().filename() == "random" && file.path().extension() == ".jsonl");
}

TEST_F(APathfinder, IsNeverSentToLineZero) {
  file("empty.toml", "");
  file("bare.json", "{}");
  for (const auto& arguments : std::vector<std::vector<std::string>>{{"robot", "show", "./empty.toml"},
                                                                     {"rules", "show", "./empty.toml"},
                                                                     {"report", "bare.json", "-o", "a.html"},
                                                                     {"report", "corridor.txt", "-o", "a.html"},
                                                                     {"race", "--mice", "ariadne:prior=bare.json"},
                                                                     {"score", "bare.json"},
                                                                     {"show", "bare.json"}}) {
    const Ended ended = labmouse(arguments);
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, Not(HasSubstr(":0:"))) << arguments.front();
    EXPECT_THAT(ended.err, HasSubstr("error")) << arguments.front();
  }
}

TEST_F(APathfinder, IsToldOfOtherEncodings) {
  std::string wide = "\xFF\xFE";
  for (const char letter : std::string(corridor)) wide += {letter, '\0'};
  const std::string packed = std::string("\x1F\x8B\x08", 3) + std::string(20, 'x');
  for (const auto& [bytes, name] :
       {std::pair(wide, "UTF-16"), std::pair(wide.substr(2), "UTF-16"), std::pair(packed, "gzip")}) {
    file("odd.toml", bytes);
    for (const auto& arguments :
         std::vector<std::vector<std::string>>{{"show", "odd.toml"},
                                               {"robot", "show", "odd.toml"},
                                               {"rules", "show", "odd.toml"},
                                               {"replay", "odd.toml"},
                                               {"race", "--mice", "flood", "--baseline", "odd.toml"},
                                               {"run", "ariadne:prior=odd.toml", "corridor.txt"}}) {
      const Ended ended = labmouse(arguments);
      EXPECT_EQ(ended.code, 2) << arguments.front();
      EXPECT_THAT(ended.err, HasSubstr(name)) << arguments.front();
    }
  }
}

TEST_F(APathfinder, IsToldTheHeadings) {
  const Ended ended = labmouse({"show", "corridor.txt", "--start", "0,0,up"});
  EXPECT_EQ(ended.code, 2);
  for (const char* heading : {"north", "east", "south", "west"}) EXPECT_THAT(ended.err, HasSubstr(heading));
  is_refused({"show", "corridor.txt", "--start", "0,0,nort"}, "'nort'", "'north'");
}

TEST_F(APathfinder, ReadsHowAMouseWorks) {
  const std::string sheet = labmouse({"mice", "flood"}).out;
  for (const char* part : {"flood: flood fill", "Method\n", "distances", "Source\n", "1980s", "stride=3"})
    EXPECT_THAT(sheet, HasSubstr(part));
  EXPECT_THAT(sheet, Not(HasSubstr("certify")));
  const auto mice = nlohmann::json::parse(labmouse({"mice", "--format", "json"}).out);
  for (const auto& mouse : mice) {
    const std::string name = mouse.at("name");
    EXPECT_NE(mouse.at("method"), "") << name;
    EXPECT_NE(mouse.at("source"), "") << name;
    EXPECT_EQ(nlohmann::json::parse(labmouse({"mice", name, "--format", "json"}).out), mouse);
    EXPECT_EQ(labmouse({"mice", name}).code, 0) << name;
  }
  is_refused({"mice", "flod"}, "'flod'", "'flood'");
  EXPECT_THAT(labmouse({"mice", "oracle"}).out, HasSubstr("knows the maze"));
}

}  // namespace
}  // namespace labmouse
