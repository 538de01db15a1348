#include "labmouse/lab/result_folders/results_folder.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "labmouse/lab/system/files.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

/// A place for a folder that goes away with the test.
class AResultsFolder : public testing::Test {
 protected:
  ~AResultsFolder() override { fs::remove_all(folder_); }

  std::string path(const std::string& name = "") const { return (folder_ / name).string(); }
  void leave(const std::string& name, const std::string& content) const {
    EXPECT_EQ(write_file(path(name), content), "");
  }
  void leave_record(const std::string& name, const std::string& mouse) const {
    leave(name, R"({"labmouse":"record","format":1,"mouse":{"name":")" + mouse + "\"}}\n{}\n");
  }
  std::vector<std::string> files() const {
    std::vector<std::string> list;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      list.push_back(fs::relative(entry.path(), folder_).string());
    return list;
  }
  std::string error(bool overwrite = false) const { return ResultsFolder(folder_.string(), overwrite).error(); }

  fs::path folder_ = fs::temp_directory_path() / ("labmouse-results-" + std::to_string(getpid()) + "-" +
                                                  testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(AResultsFolder, IsMadeAndLeftEmpty) {
  EXPECT_EQ(ResultsFolder(path("deep/er"), false).error(), "");
  EXPECT_THAT(files(), UnorderedElementsAre("deep", "deep/er"));
}

TEST_F(AResultsFolder, MayHoldOtherThings) {
  leave("notes.txt", "mine");
  leave("mazes/one.txt", "mine");
  leave_record("walks/one-1.jsonl", "flood");  // from `run --record`
  EXPECT_EQ(error(), "");
  EXPECT_EQ(error(true), "");
  EXPECT_THAT(files(), UnorderedElementsAre("notes.txt", "mazes", "mazes/one.txt", "walks", "walks/one-1.jsonl"));
}

TEST_F(AResultsFolder, IsRefusedWithTheResultsOfAnotherRace) {
  leave("results.json", "{}");
  EXPECT_THAT(error(), HasSubstr("--overwrite"));
  EXPECT_THAT(files(), UnorderedElementsAre("results.json"));
}

TEST_F(AResultsFolder, IsRefusedWithTheRecordsOfARaceThatWasKilled) {
  leave_record("flood_stride=1/one-1.jsonl", "flood:stride=1");
  EXPECT_THAT(error(), HasSubstr("--overwrite"));
}

TEST_F(AResultsFolder, LosesJustWhatARaceLeftWhereThatIsReplaced) {
  leave("results.json", "{}");
  leave("notes.txt", "mine");
  leave_record("flood/one-1.jsonl", "flood");
  leave_record("flood/one-2.jsonl", "flood");
  leave("flood/one.svg", "<svg/>");
  leave_record("mms_._mouse~2/one.jsonl", "mms:./mouse");
  leave_record("certify/one-1.jsonl", "certify");
  leave("certify/mine.svg", "<svg/>");
  leave("certify/odd.jsonl", "no record");
  EXPECT_EQ(error(true), "");
  EXPECT_THAT(files(), UnorderedElementsAre("notes.txt", "certify", "certify/mine.svg", "certify/odd.jsonl"));
}

TEST_F(AResultsFolder, IsTakenByOneRaceAtATime) {
  {
    const ResultsFolder first(path(), false);
    EXPECT_EQ(first.error(), "");
    EXPECT_THAT(error(), HasSubstr("another race"));
    EXPECT_THAT(error(true), HasSubstr("another race"));
    EXPECT_THAT(error(), HasSubstr("another race"));  // who was refused unlocked nothing
  }
  EXPECT_EQ(error(), "");
}

TEST_F(AResultsFolder, IsFreeOnceTheProcessThatHadItWasKilled) {
  int ends[2] = {-1, -1};
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    const ResultsFolder taken(path(), false);
    const char good = taken.error().empty() ? '1' : '0';
    if (write(ends[1], &good, 1) == 1) pause();
    _exit(1);
  }
  char good = 0;
  ASSERT_EQ(read(ends[0], &good, 1), 1);
  EXPECT_EQ(good, '1');
  EXPECT_THAT(error(), HasSubstr("another race"));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_EQ(error(), "");
  EXPECT_THAT(files(), UnorderedElementsAre());
  close(ends[0]);
  close(ends[1]);
}

TEST_F(AResultsFolder, IsAFolder) {
  leave("file", "mine");
  EXPECT_THAT(ResultsFolder(path("file"), true).error(), HasSubstr("cannot create the folder"));
  EXPECT_THAT(ResultsFolder("", true).error(), HasSubstr("is empty"));
  for (const char* stream : {"-", "/dev/stdout"}) EXPECT_THAT(ResultsFolder(stream, true).error(), HasSubstr("folder"));
  EXPECT_FALSE(fs::exists("-"));
}

}  // namespace
}  // namespace labmouse
