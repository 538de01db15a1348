// labmouse study from end to end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/program.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::json;
using test::content_of;
using test::Ended;
using test::Says;
using ::testing::HasSubstr;
using ::testing::Not;

/// A user in a folder with mazes: five halls, one of them twice, and one without a way.
class AStudent : public testing::Test {
 protected:
  AStudent() {
    std::filesystem::create_directories(folder_ / "mazes");
    for (int cells = 2; cells <= 6; ++cells)
      file("mazes/hall-" + std::to_string(cells) + ".txt", hall('S', cells, 'G'));
    file("mazes/mirrored.txt", hall('G', 4, 'S'));
    file("mazes/shut.txt", "o---o---o\n| S | G |\no---o---o\n");
  }
  ~AStudent() override { std::filesystem::remove_all(folder_); }

  /// A row of cells with one letter in the western end and another one in the eastern end.
  static std::string hall(char west, int cells, char east) {
    std::string wall = "o", row(static_cast<std::size_t>(cells) * 4 + 1, ' ');
    for (int i = 0; i < cells; ++i) wall += "---o";
    row.front() = row.back() = '|';
    row[2] = west;
    row[row.size() - 3] = east;
    return wall + "\n" + row + "\n" + wall + "\n";
  }
  void file(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
  }
  std::string content(const std::string& name) const { return content_of(folder_ / name); }
  Ended study(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "study");
    return test::Program(folder_, std::move(arguments)).wait();
  }
  /// Bad usage or input: exit code 2, one line on standard error, which has these parts, nothing on standard output.
  template <typename... Parts>
  void is_refused(std::vector<std::string> arguments, Parts... parts) const {
    const Ended ended = study(std::move(arguments));
    EXPECT_EQ(ended.code, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_THAT(ended.err, Says(parts...));
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("labmouse-study-" + std::to_string(getpid()) + "-" +
                                                testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(AStudent, ComparesTwoMice) {
  const Ended ended = study({"--mice", "flood,certify", "--mazes", "mazes", "--folds", "2", "--csv", "out/study.csv",
                             "--svg", "out/study.svg"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_THAT(ended.out, Says("2 mice", "5 mazes", "2 folds", "seed 1"));
  EXPECT_THAT(ended.out, HasSubstr("\ncertify - flood "));
  EXPECT_THAT(ended.out, Says("1 duplicate", "\n  mazes/mirrored.txt = mazes/hall-4.txt\n"));
  EXPECT_THAT(ended.out, Says("1 maze", "goal", "\n  mazes/shut.txt\n"));
  const std::string csv = content("out/study.csv");
  EXPECT_THAT(csv, HasSubstr("maze,fold,bound,flood,certify\nmazes/hall-2.txt,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 5);
  EXPECT_THAT(content("out/study.svg"), HasSubstr("certify against flood"));
}

TEST_F(AStudent, GetsNothingButJson) {
  const Ended ended = study({"--mice", "flood,certify", "--mazes", "mazes", "--folds", "5", "--format", "json"});
  const Json json = Json::parse(ended.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded());
  EXPECT_EQ(json["groups"][0].at("mazes").size(), 5U);
  EXPECT_EQ(json.at("folds").size(), 5U);
  EXPECT_EQ(json.at("duplicates").at(0).at("name"), "mazes/mirrored.txt");
  EXPECT_EQ(json.at("routeless").at(0), "mazes/shut.txt");
  EXPECT_EQ(json.at("learning"), true);
  EXPECT_EQ(Json::parse(study({"--mice", "flood", "--no-learning", "--format", "json"}).out).at("learning"), false);
}

TEST_F(AStudent, DealsOtherFoldsWithAnotherSeed) {
  const auto csv = [this](const char* seed) {
    EXPECT_EQ(study({"--mice", "flood", "--mazes", "mazes", "--folds", "2", "--seed", seed, "--csv", "folds.csv"}).code,
              0);
    return content("folds.csv");
  };
  const std::string one = csv("1");
  EXPECT_EQ(csv("1"), one);
  EXPECT_TRUE(csv("2") != one || csv("3") != one || csv("4") != one);
}

TEST_F(AStudent, IsToldInOneLineWhatIsWrong) {
  is_refused({}, "--mice", "required");
  is_refused({"--mice", "flod"}, "'flod'", "'flood'");
  is_refused({"--mice", "flood", "--folds", "1"}, "--folds");
  is_refused({"--mice", "flood", "--mazes", "mazes", "--folds", "6"}, "5 different mazes", "7 given", "6 folds",
             "5 folds");
  is_refused({"--mice", "flood", "--mazes", "mazes/shut.txt"}, "0 different mazes", "1 given", "at least 2");
  is_refused({"--mice", "flood", "--format", "csv"}, "--format");
  is_refused({"--mice", "flood", "--csv", "one", "--svg", "one"}, "--csv", "--svg");
}

TEST_F(AStudent, IsToldOfUnwritableFilesBeforeTheWork) {
  file("occupied", "a file where a folder should be");
  for (const char* option : {"--csv", "--svg"}) {
    is_refused({"--mice", "flood", "--mazes", "mazes", "--folds", "2", option, "occupied/file"},
               "occupied/file: error: ", "not a folder");
    is_refused({"--mice", "flood", "--mazes", "mazes", "--folds", "2", option, "mazes"},
               "mazes: error: ", "is a folder");
  }
}

TEST_F(AStudent, WhoInterruptsAtOnceLosesNoFile) {
  file("study.csv", "maze,fold,bound,kept");
  const test::Program program(folder_, {"study", "--mice", "random,flood", "--folds", "2", "--runs", "5000", "--jobs",
                                        "1", "--csv", "study.csv"});
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!program.handles_interrupts() && std::chrono::steady_clock::now() < patience) std::this_thread::yield();
  program.interrupt();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_THAT(ended.out, Says("Stopped", "0 of 2 folds"));
  EXPECT_EQ(content("study.csv"), "maze,fold,bound,kept");
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    EXPECT_THAT(entry.path().filename().string(), Not(testing::EndsWith(".part")));
}

}  // namespace
}  // namespace labmouse
