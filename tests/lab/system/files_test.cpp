#include "labmouse/lab/system/files.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "labmouse/lab/system/streams.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

/// An empty folder that goes away with the test.
class Files : public testing::Test {
 protected:
  Files() { fs::create_directories(folder_); }
  ~Files() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string content(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::vector<std::string> names() const {
    std::vector<std::string> list;
    for (const auto& entry : fs::directory_iterator(folder_)) list.push_back(entry.path().filename().string());
    return list;
  }
  std::string pipe_named(const std::string& name) const {
    EXPECT_EQ(mkfifo(path(name).c_str(), 0600), 0);
    return path(name);
  }

  fs::path folder_ = fs::temp_directory_path() / ("labmouse-files-" + std::to_string(getpid()) + "-" +
                                                  testing::UnitTest::GetInstance()->current_test_info()->name());
};

/// A pipe that holds the text and has no writer any more, under the name that a shell gives it.
class FullPipe {
 public:
  explicit FullPipe(const std::string& text) {
    int ends[2] = {-1, -1};
    EXPECT_EQ(pipe(ends), 0);
    EXPECT_EQ(write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
    close(ends[1]);
    end_ = ends[0];
  }
  FullPipe(const FullPipe&) = delete;
  FullPipe& operator=(const FullPipe&) = delete;
  ~FullPipe() { close(end_); }

  std::string path() const { return "/dev/fd/" + std::to_string(end_); }

 private:
  int end_ = -1;
};

/// No file of this process may become larger, for as long as this lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &now);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

/// Root may write all files, so where it runs these tests it is somebody else for as long as this lives.
class SomebodyElse {
 public:
  SomebodyElse() {
    if (before_ != 0) return;
    EXPECT_EQ(seteuid(65534), 0);
  }
  SomebodyElse(const SomebodyElse&) = delete;
  SomebodyElse& operator=(const SomebodyElse&) = delete;
  ~SomebodyElse() { EXPECT_EQ(seteuid(before_), 0); }

 private:
  uid_t before_ = geteuid();
};

TEST_F(Files, AreReadAsTheyWereWritten) {
  const std::string bytes(100'000, '\0');
  EXPECT_EQ(write_file(path("deep/er/file"), bytes), "");
  EXPECT_EQ(read_file(path("deep/er/file")).content, bytes);
  EXPECT_THAT(names(), UnorderedElementsAre("deep"));
}

TEST_F(Files, SayWhyTheyCannotBeRead) {
  EXPECT_THAT(read_file(path("none")).error, HasSubstr("no such"));
  EXPECT_THAT(read_file(folder_.string()).error, HasSubstr("is a folder"));
  EXPECT_THAT(read_file("").error, HasSubstr("empty"));
  write_file(path("file"), "12345");
  EXPECT_THAT(read_file(path("file/inner")).error, HasSubstr("not a folder"));
  EXPECT_EQ(read_file(path("file"), 5).content, "12345");
  EXPECT_THAT(read_file(path("file"), 4).error, HasSubstr("5 bytes"));
}

TEST_F(Files, OfOtherEncodingsAreNamed) {
  using namespace std::string_literals;
  write_file(path("a"), "\x1F\x8B\x08 and so on"s);
  write_file(path("b"), "\xFF\xFEo\0-\0"s);
  write_file(path("c"), "o\0-\0-\0o\0"s);
  write_file(path("d"), "\0{\0}\0\n"s);
  write_file(path("e"), "\xEF\xBB\xBF{}"s);
  EXPECT_THAT(read_file(path("a")).error, HasSubstr("gzip"));
  for (const char* name : {"b", "c", "d"}) EXPECT_THAT(read_file(path(name)).error, HasSubstr("UTF-16")) << name;
  EXPECT_EQ(read_file(path("e")).error, "");
}

TEST_F(Files, ThatAreMazesInBytesAreNoTextOfAnotherEncoding) {
  std::string bytes(256, '\0');
  for (std::size_t i = 0; i < bytes.size(); i += 2) bytes[i] = static_cast<char>(i % 32 < 16 ? 9 + i % 2 : 10);
  write_file(path("open.maz"), bytes);
  EXPECT_EQ(read_file(path("open.maz")).error, "");
}

TEST_F(Files, MayBePipesThatAreAskedForTwice) {
  const std::string text(50'000, 'x');
  const FullPipe pipe(text);
  EXPECT_EQ(read_file(pipe.path()).content, text);
  EXPECT_EQ(read_file(pipe.path()).content, text);
  EXPECT_THAT(read_file(pipe.path(), 40'000).error, HasSubstr("too large"));
}

TEST_F(Files, MayBePipesWithNames) {
  const std::string pipe = pipe_named("pipe");
  std::thread writer([&] { EXPECT_EQ(write_file(pipe, "through"), ""); });
  EXPECT_EQ(read_file(pipe).content, "through");
  writer.join();
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(Files, ThatAreFoundAreNotWaitedFor) {
  EXPECT_THAT(read_found_file(pipe_named("pipe")).error, HasSubstr("pipe"));
  const FullPipe pipe("text");
  EXPECT_NE(read_found_file(pipe.path()).error, "");
}

TEST_F(Files, FromAnEndlessDeviceAreTooLarge) { EXPECT_THAT(read_file("/dev/zero").error, HasSubstr("too large")); }

TEST_F(Files, SayWhyTheyCannotBeWritten) {
  write_file(path("file"), "kept");
  fs::create_directories(path("inner"));
  fs::create_symlink("nowhere/file", path("astray"));
  fs::create_symlink("circle", path("circle"));
  const auto refused = [&](const std::string& where, const std::string& cause) {
    EXPECT_THAT(write_file(where, "text"), HasSubstr(cause));
    EXPECT_THAT(check_writable(where), HasSubstr(cause));
  };
  refused("", "empty");
  refused(path("inner"), "is a folder");
  refused(path("new/"), "folder");
  refused(path("file/inner"), "not a folder");
  refused(path("astray"), "no such folder");
  refused(path("circle"), "loop");
  refused(path(std::string(256, 'n')), "too long");
  EXPECT_THAT(names(), UnorderedElementsAre("file", "inner", "astray", "circle"));
  EXPECT_EQ(content("file"), "kept");
}

TEST_F(Files, SayThatThereIsNoSpace) { EXPECT_THAT(write_file("/dev/full", "text"), HasSubstr("no space")); }

TEST_F(Files, AreWrittenWholeOrNotAtAllUnderALimit) {
  write_file(path("old"), "kept");
  {
    const FileSizeLimit limit(1000);
    EXPECT_THAT(write_file(path("new"), std::string(5000, 'x')), HasSubstr("ulimit"));
    EXPECT_THAT(write_file(path("old"), std::string(5000, 'x')), HasSubstr("ulimit"));
    EXPECT_EQ(write_file(path("small"), "text"), "");
  }
  EXPECT_THAT(names(), UnorderedElementsAre("old", "small"));
  EXPECT_EQ(content("old"), "kept");
}

TEST_F(Files, MayHaveTheLongestName) {
  const std::string longest(255, 'n');
  EXPECT_EQ(check_writable(path(longest)), "");
  EXPECT_EQ(write_file(path(longest), "text"), "");
  EXPECT_THAT(names(), UnorderedElementsAre(longest));
  EXPECT_EQ(content(longest), "text");
}

TEST_F(Files, AreWrittenThroughLinksThatStay) {
  fs::create_directories(path("other"));
  write_file(path("other/old"), "old");
  fs::create_symlink("other/old", path("to-old"));
  fs::create_symlink("to-old", path("twice"));
  fs::create_symlink(path("other/new"), path("to-new"));
  EXPECT_EQ(check_writable(path("to-new")), "");
  EXPECT_FALSE(fs::exists(path("other/new")));
  EXPECT_EQ(write_file(path("to-new"), "first"), "");
  EXPECT_EQ(write_file(path("twice"), "second"), "");
  EXPECT_EQ(content("other/new"), "first");
  EXPECT_EQ(content("other/old"), "second");
  for (const char* link : {"to-old", "twice", "to-new"}) EXPECT_TRUE(fs::is_symlink(path(link))) << link;
  EXPECT_THAT(names(), UnorderedElementsAre("other", "to-old", "twice", "to-new"));
}

TEST_F(Files, KeepTheirPermissions) {
  write_file(path("mine"), "old");
  fs::permissions(path("mine"), fs::perms{0604});
  EXPECT_EQ(write_file(path("mine"), "new"), "");
  EXPECT_EQ(fs::status(path("mine")).permissions(), fs::perms{0604});
  EXPECT_EQ(content("mine"), "new");
}

TEST_F(Files, ThatAreReadOnlyStay) {
  write_file(path("mine"), "old");
  fs::permissions(path("mine"), fs::perms{0444});
  fs::permissions(folder_, fs::perms{0777});
  const SomebodyElse somebody;
  EXPECT_THAT(write_file(path("mine"), "new"), HasSubstr("permission denied"));
  EXPECT_EQ(content("mine"), "old");
}

TEST_F(Files, PassAnEarlierPartThatAKilledProcessLeft) {
  const std::string stale = ".labmouse-" + std::to_string(getpid()) + "-";
  for (int number = 0; number < 1000; ++number) std::ofstream(path(stale + std::to_string(number) + ".part")) << "cut";
  EXPECT_EQ(write_file(path("new"), "text"), "");
  EXPECT_EQ(content("new"), "text");
  EXPECT_EQ(names().size(), 1001U);
}

TEST_F(Files, ThatAreOpenAreWrittenWhereTheyStand) {
  const int file = open(path("log").c_str(), O_WRONLY | O_CREAT, 0600);
  const std::string name = "/dev/fd/" + std::to_string(file);
  EXPECT_EQ(check_writable(name), "");
  EXPECT_EQ(write_file(name, "one "), "");
  EXPECT_EQ(write_file(name, "two"), "");
  close(file);
  EXPECT_EQ(content("log"), "one two");
  EXPECT_THAT(check_writable(name), HasSubstr("not open"));
  EXPECT_THAT(names(), UnorderedElementsAre("log"));
}

TEST_F(Files, AreNoStreams) {
  write_file(path("file"), "");
  EXPECT_FALSE(is_stream(path("file")));
  EXPECT_FALSE(is_stream(path("none")));
  for (const char* name : {"-", "/dev/stdout", "/dev/fd/7", "/dev/null"}) EXPECT_TRUE(is_stream(name)) << name;
  EXPECT_TRUE(is_stream(pipe_named("pipe")));
}

}  // namespace
}  // namespace labmouse
