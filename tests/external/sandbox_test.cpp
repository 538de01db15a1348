// Ways out of a sandbox. Each is tried outside of one, too, where it leads out.
#include "labmouse/external/sandbox.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/external/bad_programs.hpp"
#include "tests/external/sandboxes.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

class Sandbox : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::has_sandboxes()) GTEST_SKIP() << "no sandboxes here: " << why_no_sandbox();
    fs::create_directories(folder_ / "own");
  }
  ~Sandbox() override { fs::remove_all(folder_); }

  /// What a script says, line by line, in its own folder.
  std::string said(const std::string& script, bool sandbox, const fs::path& folder) const {
    Launch launch;
    launch.words = {"/bin/bash", "-c", script, test::tag()};
    launch.directory = folder;
    launch.owns_directory = true;
    launch.sandbox = sandbox;
    return said_by(launch);
  }
  static std::string said_by(const Launch& launch) {
    ExternalProcess process(launch);
    EXPECT_EQ(process.error(), "");
    std::string all;
    const auto deadline = ExternalProcess::Clock::now() + 60s;
    while (process.wait(deadline) == ExternalEvent::output)
      while (const auto line = process.lines().next()) all += std::string(*line) + "\n";
    process.end(0ms);
    return all + std::string(process.errors());
  }
  std::string inside(const std::string& script) const { return said(script, true, folder_ / "own"); }
  std::string outside(const std::string& script) const { return said(script, false, folder_ / "own"); }

  /// How to start a script in its own folder.
  Launch launch(const std::string& script) const {
    Launch launch;
    launch.words = {"/bin/bash", "-c", script, test::tag()};
    launch.directory = folder_ / "own";
    launch.owns_directory = launch.sandbox = true;
    return launch;
  }
  void write(const std::string& name, const std::string& content) const { std::ofstream(folder_ / name) << content; }

  fs::path folder_ = fs::temp_directory_path() / ("labmouse-sandbox-" + test::tag());
};

TEST_F(Sandbox, LeavesNothingThatItWrites) {
  const std::string script = "echo mine > own.txt && cat own.txt; echo more > ../outside.txt && echo wrote";
  EXPECT_THAT(inside(script), HasSubstr("mine\n"));
  EXPECT_FALSE(fs::exists(folder_ / "own" / "own.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "outside.txt"));
  EXPECT_THAT(outside(script), HasSubstr("mine\nwrote\n"));
  EXPECT_TRUE(fs::exists(folder_ / "outside.txt"));
}

TEST_F(Sandbox, IsReadOnlyOutsideOfItsFolder) {
  EXPECT_THAT(inside("echo x > /usr/labmouse.txt; echo x > /labmouse.txt; echo x > /etc/labmouse.txt"),
              testing::ContainsRegex("Read-only.*\n.*Read-only.*\n.*Read-only"));
}

TEST_F(Sandbox, StartsEachTimeFromTheSameFolder) {
  write("own/seen.txt", "0");
  const Launch remembers = launch("cat seen.txt; echo -n 1 >> seen.txt; rm -f gone.txt; echo");
  write("own/gone.txt", "");
  for (int contest = 0; contest < 2; ++contest) EXPECT_EQ(said_by(remembers), "0\n");
  EXPECT_TRUE(fs::exists(folder_ / "own" / "gone.txt"));
}

TEST_F(Sandbox, KeepsItsFolderWhereThatIsWanted) {
  write("own/seen.txt", "0");
  Launch remembers = launch("cat seen.txt; echo -n 1 >> seen.txt; echo; cat maze.txt");
  auto hidden = std::make_shared<HiddenFiles>();
  write("own/maze.txt", "o---o");
  hidden->add(folder_ / "own" / "maze.txt");
  remembers.hidden = hidden;
  remembers.keeps_folder = true;
  EXPECT_EQ(said_by(remembers), "0\n");
  EXPECT_EQ(said_by(remembers), "01\n");
  EXPECT_EQ(fs::file_size(folder_ / "own" / "maze.txt"), 5U);
}

TEST_F(Sandbox, ShowsNothingThatIsHidden) {
  fs::create_directories(folder_ / "own" / "records");
  auto hidden = std::make_shared<HiddenFiles>();
  for (const char* name : {"own/maze.txt", "own/records/a.jsonl", "own/races.db-wal", "own/open.txt", "outside.txt"})
    write(name, "secret\n");
  hidden->add(folder_ / "own" / "maze.txt");
  hidden->add(folder_ / "own" / "records");
  hidden->add_store(folder_ / "own" / "races.db");
  const auto times = [](const std::string& text) {
    int count = 0;
    for (auto at = text.find("secret"); at != std::string::npos; at = text.find("secret", at + 1)) ++count;
    return count;
  };
  Launch launch =
      this->launch("ls -R; cat maze.txt records/a.jsonl races.db-wal; cat " + (folder_ / "outside.txt").string());
  EXPECT_EQ(times(said_by(launch)), 3);  // all but the one outside of its folder
  EXPECT_EQ(times(outside(launch.words[2])), 4);
  launch.hidden = hidden;
  const std::string said = said_by(launch);
  EXPECT_EQ(times(said), 0);
  EXPECT_THAT(said, testing::AllOf(HasSubstr("open.txt\n"), Not(HasSubstr("a.jsonl\n"))));
}

TEST_F(Sandbox, ShowsTheSystemAndNoFoldersOfUsers) {
  const std::string said = inside("ls /; ls /home /root /work /w /var 2> /dev/null; ls /tmp");
  for (const char* name : {"usr\n", "etc\n", "proc\n"}) EXPECT_THAT(said, HasSubstr(name));
  for (const char* name : {"home\n", "var\n", "srv\n", "mnt\n", "boot\n"}) EXPECT_THAT(said, Not(HasSubstr(name)));
}

TEST_F(Sandbox, SeesNothingOfTheProcessThatStartedIt) {
  // Neither itself nor by way of its parent, the first process there, which is a process of ours.
  const std::string script =
      "cat /proc/*/cmdline /proc/*/environ /proc/*/maps /proc/*/comm 2> /dev/null | tr '\\0' '\\n'; "
      "ls -l /proc/*/fd /proc/*/cwd /proc/*/exe 2> /dev/null";
  const std::string said = inside(script);
  EXPECT_THAT(said, HasSubstr("bash"));
  EXPECT_THAT(said, Not(HasSubstr("external_test")));
  EXPECT_THAT(outside(script), HasSubstr("external_test"));
}

TEST_F(Sandbox, KnowsNoVariableThatMayBeASecret) {
  const std::vector<const char*> secrets = {"LABMOUSE_MAZES", "_", "GRADING_SEED", "PATHS", "MY_LC_ALL", "PASSWORD"};
  for (const char* name : secrets) ASSERT_EQ(setenv(name, "/a/folder", 1), 0);
  for (const char* name : {"LC_TIME", "OMP_NUM_THREADS"}) ASSERT_EQ(setenv(name, "7", 1), 0);
  // A shell sets `_` anew for the programs that it starts.
  const std::string script = "tr '\\0' '\\n' < /proc/$$/environ";
  const std::string said = "\n" + inside(script), without = "\n" + outside(script);
  for (const char* name : secrets) {
    ASSERT_EQ(unsetenv(name), 0);
    EXPECT_THAT(said, Not(HasSubstr("\n" + std::string(name) + "="))) << name;
  }
  for (const char* name : {"LC_TIME", "OMP_NUM_THREADS"}) {
    ASSERT_EQ(unsetenv(name), 0);
    EXPECT_THAT(said, HasSubstr("\n" + std::string(name) + "=7\n"));
  }
  EXPECT_THAT(said, HasSubstr("\nPATH="));
  EXPECT_THAT(without, HasSubstr("\nPASSWORD="));
  EXPECT_THAT(without, Not(HasSubstr("\nLABMOUSE_MAZES=")));
}

TEST_F(Sandbox, LeavesNoMountsBehind) {
  const auto mounts = [] {
    std::ifstream file("/proc/self/mountinfo");
    return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
  };
  const auto before = mounts();
  inside("true");
  EXPECT_EQ(mounts(), before);
}

TEST_F(Sandbox, CannotBeMadeWritableAgain) {
  const std::string script =
      "mount -o remount,rw,bind / ; mount -o remount,rw / ; umount /tmp; unshare -Urm true && "
      "unshare -Urm sh -c 'mount -o remount,rw,bind /; echo x > ../outside.txt'; echo x > ../outside.txt";
  inside(script);
  EXPECT_FALSE(fs::exists(folder_ / "outside.txt"));
}

TEST_F(Sandbox, HasATmpOfItsOwn) {
  const fs::path name = "/tmp/labmouse-private-" + test::tag();
  EXPECT_THAT(inside("echo x > " + name.string() + " && cat " + name.string() +
                     "; ls /dev/shm; echo y > /dev/shm/y && echo shared"),
              testing::AllOf(HasSubstr("x\n"), HasSubstr("shared")));
  EXPECT_FALSE(fs::exists(name));
  EXPECT_THAT(inside("cat " + name.string()), HasSubstr("No such file"));
}

TEST_F(Sandbox, MayHaveTmpAsItsFolder) {
  const std::string name = "labmouse-tmp-" + test::tag();
  EXPECT_EQ(said("echo x > " + name + " && cat " + name + "; rm " + name, true, "/tmp"), "x\n");
}

TEST_F(Sandbox, ReachesNoListenerOnLoopback) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
  ASSERT_EQ(listen(listener, 4), 0);
  ASSERT_EQ(getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const std::string script =
      "exec 3<>/dev/tcp/127.0.0.1/" + std::to_string(ntohs(address.sin_port)) + " && echo reached";
  EXPECT_EQ(outside(script), "reached\n");
  EXPECT_THAT(inside(script), testing::AllOf(Not(HasSubstr("reached")), HasSubstr("refused")));
  close(listener);
}

TEST_F(Sandbox, SignalsNobodyOutside) {
  const std::string script = "kill -0 " + std::to_string(getpid()) + " && echo reached";
  EXPECT_EQ(outside(script), "reached\n");
  EXPECT_THAT(inside(script), Not(HasSubstr("reached")));
  // Its parent is the first process there, which no signal from there ends.
  EXPECT_EQ(inside("kill -9 $PPID; kill -STOP $PPID; echo there"), "there\n");
}

TEST_F(Sandbox, ReadsNothingOfAProcessOutside) {
  const std::string script = "tr '\\0' '\\n' < /proc/" + std::to_string(getpid()) + "/environ | grep -c ^PATH=";
  EXPECT_EQ(outside(script), "1\n");
  EXPECT_THAT(inside(script), Not(HasSubstr("1\n")));
  EXPECT_THAT(inside("ls /proc/self/fd && ps -e -o args= 2>&1 | wc -l"), Not(HasSubstr("No such file")));
}

TEST_F(Sandbox, OutlivesNobody) {
  EXPECT_EQ(inside("(setsid bash -c 'sleep 1000' " + test::tag() + " &) ; echo left"), "left\n");
  EXPECT_EQ(test::tagged_processes(), 0);
}

TEST_F(Sandbox, IsEndedWithAllInIt) {
  Launch launch;
  launch.words = {"/bin/bash", "-c",
                  "for i in 1 2 3; do setsid bash -c 'sleep 1000' " + test::tag() + " & done; echo on; wait",
                  test::tag()};
  launch.sandbox = true;
  ExternalProcess process(launch);
  ASSERT_EQ(process.wait(ExternalProcess::Clock::now() + 60s), ExternalEvent::output);
  EXPECT_GT(test::tagged_processes(), 0);
  process.end(0ms);
  EXPECT_EQ(test::tagged_processes(), 0);
}

TEST_F(Sandbox, TellsHowItsExternalEnded) {
  const auto status_of = [](const std::string& script) {
    Launch launch;
    launch.words = {"/bin/bash", "-c", script};
    launch.sandbox = true;
    ExternalProcess process(launch);
    EXPECT_EQ(process.wait(ExternalProcess::Clock::now() + 60s), ExternalEvent::ended);
    return process.status().value_or(ExitStatus());
  };
  EXPECT_EQ(status_of("exit 7"), (ExitStatus{7, 0}));
  EXPECT_EQ(status_of("kill -SEGV $$"), (ExitStatus{0, SIGSEGV}));
  EXPECT_EQ(status_of("kill -ABRT $$"), (ExitStatus{0, SIGABRT}));
}

TEST_F(Sandbox, CountsTheWorkOfItsExternal) {
  Launch launch = test::bad_program("turn");
  launch.words = {"/bin/bash", "-c", "for ((i = 0; i < 200000; ++i)); do :; done; echo done; read line"};
  launch.sandbox = true;
  ExternalProcess process(launch);
  ASSERT_EQ(process.wait(ExternalProcess::Clock::now() + 60s), ExternalEvent::output);
  EXPECT_GT(process.processor_time(), 10ms);
}

/// What a process says of itself where others can read it.
bool shows_its_command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return text.find_first_not_of('\0') != std::string::npos;
}

TEST(CommandLine, CanBeForgotten) {
  ASSERT_TRUE(shows_its_command_line());
  const pid_t child = fork();
  if (child == 0) {
    forget_command_line();
    _exit(shows_its_command_line() ? 1 : 0);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

TEST_F(Sandbox, SaysWhatCannotBeStarted) {
  Launch launch;
  launch.words = {"/bin/true"};
  launch.directory = "/no/such/folder";
  launch.sandbox = true;
  EXPECT_THAT(ExternalProcess(launch).error(), HasSubstr("No such file or directory"));
}

}  // namespace
}  // namespace labmouse
