// Stores of contests, as a user has them: kept, killed, full, shared and read with other programs.
#include <sys/mount.h>

#include <chrono>
#include <functional>
#include <random>
#include <thread>

#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using test::corridor;
using test::Ended;
using test::Program;
using test::Says;
using ::testing::HasSubstr;

class AUserOfAStore : public test::AUser {
 protected:
  AUserOfAStore() { file("corridor.txt", corridor); }

  /// A race of many short contests, with a store.
  static std::vector<std::string> long_race(const std::string& seed, const std::string& store = "results.db") {
    return {"race",   "--mice", "random",   "--mazes", "corridor.txt", "--runs", "20000",
            "--seed", seed,     "--format", "csv",     "--store",      store};
  }
  /// Results without the column of times.
  static std::string without_times(const std::string& csv) {
    std::string kept;
    for (std::size_t begin = 0, column = 0; begin < csv.size(); ++column) {
      const auto end = csv.find_first_of(",\n", begin);
      if (column != 9) kept += csv.substr(begin, end - begin + 1);
      if (csv[end] == '\n') column = static_cast<std::size_t>(-1);
      begin = end + 1;
    }
    return kept;
  }
  /// Contests that the store has, as another program sees them.
  std::size_t kept(const std::string& store = "results.db") const {
    const std::string count = shell("sqlite3 -cmd '.timeout 60000' " + store + " 'SELECT count(*) FROM contests'").out;
    return count.empty() ? 0 : std::stoul(count);
  }
  Ended shell(const std::string& line) const {
    file(".line", "labmouse() { '" LABMOUSE_PROGRAM "' \"$@\"; }\n" + line + "\n");
    const int status = std::system(("cd '" + folder_.string() + "' && bash .line > .shell-out 2> .shell-err").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), content(".shell-out"), content(".shell-err")};
  }
};

void wait_until(std::chrono::steady_clock::time_point time, const std::function<bool()>& done) {
  while (!done() && std::chrono::steady_clock::now() < time) std::this_thread::yield();
}

TEST_F(AUserOfAStore, IsToldWhatCameFromIt) {
  const std::vector<std::string> race = {"race",         "--mice",  "flood,random", "--mazes",
                                         "corridor.txt", "--store", "a.db"};
  const Ended first = labmouse(race), second = labmouse(race);
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_THAT(first.out.substr(first.out.rfind("Store ")), Says("a.db", "0", "21"));
  EXPECT_THAT(second.out.substr(second.out.rfind("Store ")), Says("a.db", "21", "0"));
  EXPECT_EQ(second.out.substr(0, second.out.rfind("Store ")), first.out.substr(0, first.out.rfind("Store ")));
  std::vector<std::string> json = race;
  json.insert(json.end(), {"--format", "json"});
  const Ended third = labmouse(json);
  EXPECT_TRUE(nlohmann::json::accept(third.out));
  EXPECT_THAT(third.err, Says("a.db", "21", "0"));
  EXPECT_THAT(first.out, HasSubstr(labmouse({"store", "race", "a.db"}).out));
}

TEST_F(AUserOfAStore, MissesNothingWhenItIsKilled) {
  const int kills = std::getenv("LABMOUSE_PROOF") != nullptr ? 200 : 10;
  std::mt19937 moments(20260101);
  std::size_t before = 0;
  unsigned latest = 400;  // ms after the start; later on a machine so busy that nothing was done by then
  for (int i = 1; i <= kills; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const Program program(folder_, long_race(std::to_string(i)));
    wait_until(begin + std::chrono::milliseconds(moments() % latest), [] { return false; });
    // What is seen here is on the disk.
    const std::size_t seen = kept();
    program.kill();
    program.wait();
    const std::size_t after = kept();
    EXPECT_GE(seen, before);
    EXPECT_GE(after, seen);
    if (after == 0 && latest < 20'000) latest *= 2;
    before = after;
  }
  EXPECT_GT(before, 0U);
  const Ended verified = labmouse({"store", "verify", "results.db", "--share", "0.001"});
  EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
  const std::string last = std::to_string(kills);
  const Ended again = labmouse(long_race(last));
  EXPECT_EQ(again.code, 0) << again.err;
  std::vector<std::string> plain = long_race(last);
  plain.resize(plain.size() - 2);
  EXPECT_EQ(without_times(again.out), without_times(labmouse(plain).out));
  EXPECT_GE(kept(), 20000U);
}

TEST_F(AUserOfAStore, RacesTwiceAtOnce) {
  const Program one(folder_, long_race("1"));
  std::filesystem::create_directory(folder_ / "other");
  std::filesystem::copy_file(folder_ / "corridor.txt", folder_ / "other/corridor.txt");
  const Program other(folder_ / "other", long_race("1", "../results.db"));
  const Ended first = one.wait(), second = other.wait();
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(second.code, 0) << second.err;
  EXPECT_EQ(without_times(first.out), without_times(second.out));
  EXPECT_EQ(kept(), 20000U);
}

TEST_F(AUserOfAStore, KeepsWhatIsDoneAtCtrlC) {
  std::vector<std::string> race = long_race("1");
  race[6] = "900000";
  const Program program(folder_, race);
  wait_until(std::chrono::steady_clock::now() + std::chrono::seconds(60), [&] { return kept() > 0; });
  program.interrupt();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 130);
  EXPECT_EQ(kept(), static_cast<std::size_t>(std::count(ended.out.begin(), ended.out.end(), '\n')) - 1);
}

TEST_F(AUserOfAStore, IsToldThatTheDiskIsFull) {
  // A file that may not grow further is what a full disk is to a program.
  const std::string race = "labmouse race --mice random --mazes corridor.txt --runs 40000 --format csv --store full.db";
  const Ended full = shell("ulimit -f 2000; " + race + " > /dev/null");
  EXPECT_EQ(full.code, 2);
  EXPECT_THAT(full.err, HasSubstr("full.db: error: cannot be written"));
  EXPECT_THAT(shell("ulimit -f 8; " + race + " --seed 2 > /dev/null").err,
              HasSubstr("full.db: error: cannot be written"));
  EXPECT_EQ(labmouse({"store", "verify", "full.db", "--share", "0.01"}).code, 0);
  const Ended again = shell(race);
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(kept("full.db"), 40000U);
  EXPECT_EQ(shell("ulimit -f 8; labmouse race --mice flood --mazes corridor.txt --store new.db").code, 2);
  EXPECT_EQ(labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--store", "new.db"}).code, 0);
}

/// A disk of its own, as small as that, where this user may make one.
class SmallDisk {
 public:
  SmallDisk(std::filesystem::path folder, const char* size) : folder_(std::move(folder)) {
    std::filesystem::create_directories(folder_);
    is_there_ = mount("none", folder_.c_str(), "tmpfs", 0, (std::string("size=") + size).c_str()) == 0;
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    if (is_there_) umount2(folder_.c_str(), MNT_DETACH);
  }

  bool is_there() const { return is_there_; }

 private:
  std::filesystem::path folder_;
  bool is_there_ = false;
};

TEST_F(AUserOfAStore, GoesOnAfterADiskWasFull) {
  const SmallDisk disk(folder_ / "disk", "2m");
  if (!disk.is_there()) GTEST_SKIP() << "this user may not mount a tmpfs: a disk that is full is not tried";
  const auto race = [&](const char* runs) {
    return labmouse({"race", "--mice", "random", "--mazes", "corridor.txt", "--runs", runs, "--format", "csv",
                     "--store", "disk/full.db"});
  };
  const Ended full = race("40000");
  EXPECT_EQ(full.code, 2);
  EXPECT_THAT(full.err, Says("disk/full.db: error: cannot be written", "no space"));
  // It says what it did, and keeps a part of that.
  const std::size_t before = kept("disk/full.db");
  EXPECT_GT(before, 0U);
  EXPECT_EQ(labmouse({"store", "verify", "disk/full.db", "--share", "0.01"}).code, 0);
  // Neither does a merge leave anything where there is no room for it.
  const Ended merged = labmouse({"store", "merge", "disk/full.db", "-o", "disk/all.db"});
  EXPECT_EQ(merged.code, 2);
  EXPECT_THAT(merged.err, Says("disk/all.db", "error: cannot be written", "no space"));
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "disk"))
    EXPECT_THAT(entry.path().filename().string(), testing::StartsWith("full.db"));
  EXPECT_EQ(shell("mount -o remount,size=64m disk").code, 0);
  const Ended again = race("40000");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr(std::to_string(before) + " contests from it"));
  EXPECT_EQ(kept("disk/full.db"), 40000U);
}

TEST_F(AUserOfAStore, IsRefusedWithALine) {
  file("text.db", "no store" + std::string(5000, ' '));
  for (const char* command : {"list", "show", "race", "export", "verify"}) {
    is_refused({"store", command, "text.db"}, "text.db: error: ");
    is_refused({"store", command, "missing.db"}, "missing.db: error: ");
    is_refused({"store", command, "."}, ".: error: ");
  }
  is_refused({"store", "forget", "missing.db", "--mouse", "flood"}, "missing.db: error: ");
  is_refused({"store", "merge", "missing.db", "-o", "all.db"}, "missing.db: error: ");
  is_refused({"race", "--mice", "flood", "--store", "text.db"}, "text.db: error: ");
  is_refused({"race", "--mice", "flood", "--store", "/dev/full"}, "/dev/full: error: ");
  for (const char* shard : {"0/3", "4/3", "1", "1/", "/3", "1.5/3", "-1/3", "x"})
    is_refused({"race", "--mice", "flood", "--store", "a.db", "--shard", shard}, "--shard", shard);
  is_refused({"race", "--mice", "flood", "--shard", "1/3"}, "--store");
  EXPECT_EQ(labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--store", "a.db"}).code, 0);
  is_refused({"store", "forget", "a.db"}, "--mouse");
  is_refused({"store", "race", "a.db", "--mouse", "certify"}, "a.db: error: ");
}

TEST_F(AUserOfAStore, MergesShards) {
  std::vector<std::string> merge = {"store", "merge"};
  for (const char* number : {"1", "2", "3"}) {
    const std::string part = std::string("part-") + number + ".db";
    EXPECT_EQ(labmouse({"race", "--mice", "flood,random", "--mazes", "corridor.txt", "contest-01", "--store", part,
                        "--shard", std::string(number) + "/3"})
                  .code,
              0);
    merge.push_back(part);
  }
  merge.insert(merge.end(), {"-o", "all.db"});
  EXPECT_EQ(labmouse(merge).code, 0);
  const Ended merged = labmouse({"store", "race", "all.db", "--format", "csv"});
  const Ended whole =
      labmouse({"race", "--mice", "flood,random", "--mazes", "corridor.txt", "contest-01", "--format", "csv"});
  EXPECT_EQ(without_times(merged.out), without_times(whole.out));
}

TEST_F(AUserOfAStore, RacesAnExternalMouseAgainOnceItsFileIsAnother) {
  const auto race = [&](std::vector<std::string> more = {}) {
    std::vector<std::string> arguments = {"race",    "--mice", "program:python3 mouse.py", "--mazes", "corridor.txt",
                                          "--store", "g.db"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = labmouse(arguments);
    return ended.out.substr(ended.out.rfind("Store "));
  };
  std::filesystem::copy_file(std::filesystem::path(LABMOUSE_SOURCE_DIR) / "templates/program.py", folder_ / "mouse.py");
  EXPECT_THAT(race(), Says("0", "1 added"));
  EXPECT_THAT(race(), Says("1 contest", "0 added"));
  std::ofstream(folder_ / "mouse.py", std::ios::app) << "# another\n";
  EXPECT_THAT(race(), Says("0", "1 added"));
  EXPECT_THAT(race({"--label", "v1"}), Says("0", "1 added"));
  std::ofstream(folder_ / "mouse.py", std::ios::app) << "# a third\n";
  EXPECT_THAT(race({"--label", "v1"}), Says("1 contest", "0 added"));
  EXPECT_EQ(labmouse({"store", "verify", "g.db", "--share", "1"}).code, 0);
}

TEST_F(AUserOfAStore, RunsNoProgramOfAStoreUnasked) {
  // Anybody can write a store that names `program:sh -c ...`; this program leaves a trace where it is started.
  const std::string trace = "open('started', 'w').close()\n";
  file("mouse.py", trace + test::content_of(std::filesystem::path(LABMOUSE_SOURCE_DIR) / "templates/program.py"));
  const std::string spec = "program:python3 mouse.py";
  labmouse({"race", "--mice", spec, "--mazes", "corridor.txt", "--store", "g.db", "--keep-folder"});
  ASSERT_TRUE(std::filesystem::remove(folder_ / "started"));
  const Ended unasked = labmouse({"store", "verify", "g.db", "--share", "1"});
  EXPECT_EQ(unasked.code, 0);
  EXPECT_THAT(unasked.out, Says("0 contests", "1 contest", "--run-programs", spec));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "started"));
  is_refused({"store", "verify", "g.db", "--share", "1", "--run-programs", "--sandbox", "off"}, "--sandbox off");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "started"));
  const Ended asked = labmouse({"store", "verify", "g.db", "--share", "1", "--run-programs", "--keep-folder"});
  EXPECT_EQ(std::filesystem::exists(folder_ / "started"), asked.code == 0) << asked.err;
  if (asked.code == 2) GTEST_SKIP() << "this system has no sandboxes: " << asked.err;
  EXPECT_THAT(asked.err, HasSubstr(spec));
  EXPECT_THAT(asked.out, Says("1 contest", "1 equal"));
}

TEST_F(AUserOfAStore, RunsNoProgramThatIsHiddenInASpec) {
  file("mouse.sh", "touch started\n");
  file("mice.toml", "[[mouse]]\nname = \"m\"\nprogram = \"sh mouse.sh\"\n");
  labmouse({"race", "--mice", "program:sh mouse.sh", "--mazes", "corridor.txt", "--store", "g.db", "--keep-folder"});
  ASSERT_TRUE(std::filesystem::remove(folder_ / "started"));
  for (const char* spec : {"mice-file:mice.toml", "X=program:sh mouse.sh", "X=mice-file:mice.toml"}) {
    shell("sqlite3 g.db \"UPDATE mice SET spec = '" + std::string(spec) + "'\"");
    const Ended ended = labmouse({"store", "verify", "g.db", "--share", "1"});
    EXPECT_THAT(ended.out, Says("0 contests", "1 other")) << spec << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "started")) << spec;
  }
}

TEST_F(AUserOfAStore, IsToldThatAFileSystemIsReadOnly) {
  std::filesystem::create_directory(folder_ / "disk");
  labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--store", "disk/old.db"});
  const std::string on_it = "unshare -rm sh -c 'mount --bind disk disk && mount -o remount,bind,ro disk && ";
  if (shell(on_it + "! touch disk/x'").code != 0) GTEST_SKIP() << "this user may not mount a folder read-only";
  for (const char* store : {"new.db", "old.db"}) {
    const Ended ended =
        shell(on_it + "'\"'" LABMOUSE_PROGRAM "' race --mice certify --mazes corridor.txt --store disk/" + store + '"');
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, Says(std::string("disk/") + store + ": error: ", "read-only"));
  }
}

TEST_F(AUserOfAStore, ReadsItWithSqlite) {
  labmouse({"race", "--mice", "flood,random", "--mazes", "corridor.txt", "--store", "a.db"});
  EXPECT_EQ(shell("sqlite3 a.db 'SELECT mouse, contests FROM standings ORDER BY mouse'").out, "flood|1\nrandom|20\n");
  EXPECT_EQ(shell("sqlite3 a.db 'PRAGMA integrity_check; PRAGMA foreign_key_check'").out, "ok\n");
  const std::string signature = labmouse({"bench", "--signature"}).out;
  EXPECT_THAT(shell("sqlite3 a.db \"SELECT text FROM mice WHERE name = 'flood'\"").out, HasSubstr(signature));
}

}  // namespace
}  // namespace labmouse
