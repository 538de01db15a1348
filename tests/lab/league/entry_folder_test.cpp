#include "labmouse/lab/league/entry_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace labmouse {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

namespace fs = std::filesystem;

const std::string heading = "authors = [\"Ada\", \"Ben\"]\nlicence = \"MIT\"\n";

std::string manifest(const std::string& lines) { return heading + "[[mouse]]\nname = \"hugger\"\n" + lines + "\n"; }

TEST(EntryManifest, NamesAMouseItsAuthorsAndItsLicence) {
  const EntryManifestResult read = read_manifest("robot = \"kerise\"\n" + manifest("program = \"python3 mouse.py\""));
  ASSERT_THAT(read.problems, SizeIs(0));
  EXPECT_EQ(read.entry.name, "hugger");
  EXPECT_THAT(read.entry.authors, ElementsAre("Ada", "Ben"));
  EXPECT_EQ(read.entry.licence, "MIT");
  EXPECT_EQ(read.entry.robot, "kerise");
  EXPECT_EQ(read.entry.kind, "program");
  EXPECT_EQ(read.entry.launch, "python3 mouse.py");
}

TEST(EntryManifest, MustBeComplete) {
  const std::string mouse = "[[mouse]]\nname = \"x\"\nmouse = \"flood\"\n";
  EXPECT_THAT(read_manifest(heading + mouse).problems, SizeIs(0));
  EXPECT_THAT(read_manifest("licence = \"MIT\"\n" + mouse).problems, SizeIs(1));
  EXPECT_THAT(read_manifest("authors = [\"Ada\"]\n" + mouse).problems, SizeIs(1));
  EXPECT_THAT(read_manifest("authors = [\"\\n\"]\nlicence = \"MIT\"\n" + mouse).problems, SizeIs(1));
  EXPECT_THAT(read_manifest(heading + mouse + "[[mouse]]\nname = \"y\"\nmouse = \"flood\"\n").problems, SizeIs(1));
  EXPECT_THAT(read_manifest(heading).problems, SizeIs(1));
}

TEST(EntryManifest, HasTheConditionsOfAllOthers) {
  EXPECT_THAT(read_manifest(manifest("program = \"./m\"\nlimits = { memory = 9999 }")).problems, SizeIs(1));
  EXPECT_THAT(read_manifest(manifest("program = \"./m\"\nlimits = { cpu = 9 }")).problems, SizeIs(1));
  EXPECT_THAT(read_manifest(manifest("program = \"./m\"\nruns = 9")).problems, SizeIs(1));
}

TEST(EntryManifest, StaysInItsFolder) {
  for (const char* good :
       {"program = \"./m --fast\"", "program = \"/usr/bin/python3 a..b.py\"", "program = \"./m ...\"",
        "program = \"./m\"\ndirectory = \"sub/folder\"", "program = \"./m 1/2 'a b'\""})
    EXPECT_THAT(read_manifest(manifest(good)).problems, SizeIs(0)) << good;
  for (const char* bad :
       {"program = \"cat ../other/mouse.py\"", "program = \"./m sub/../../x\"", "program = \"./m --in=../x\"",
        "program = \"./m '/home/ada'\"", "program = \"./m\"\narguments = [\"..\"]", "program = \"~/m\"",
        "program = \"./m\"\nenvironment = { PYTHONPATH = \"lib:../other\" }", "program = \"./m\"\ndirectory = \"/tmp\"",
        "capstone = \"../robot.py\"", "capstone = \"robot.py\"\ninterpreter = \"/opt/../home/python\"",
        "mouse = \"certify:prior=/home/ada/prior\"", "program = \"./m /\"", "program = './m /\"\"home/ada'",
        "program = './m .\"\"./x'", "program = './m /\\home'", "program = \"./m '/'home\""})
    EXPECT_THAT(read_manifest(manifest(bad)).problems, SizeIs(1)) << bad;
}

class AnEntryFolder : public ::testing::Test {
 protected:
  AnEntryFolder() {
    fs::remove_all(folder_);
    fs::create_directories(from_ / "sub");
    write("mouse.py", "print()");
    write("sub/data", "1");
  }
  ~AnEntryFolder() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(from_ / name) << text; }
  std::string copied() const { return copy_entry(from_.string(), to_.string()); }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     ("entry_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name())),
           from_ = folder_ / "from", to_ = folder_ / "to";
};

TEST_F(AnEntryFolder, IsCopied) {
  fs::permissions(from_ / "mouse.py", fs::perms::owner_all);
  EXPECT_EQ(copied(), "");
  EXPECT_EQ(fs::file_size(to_ / "mouse.py"), 7U);
  constexpr auto all_run = fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;
  EXPECT_EQ(fs::status(to_ / "mouse.py").permissions() & all_run, all_run);
  EXPECT_EQ(fs::status(to_ / "sub/data").permissions() & all_run, fs::perms::none);
  EXPECT_EQ(fs::file_size(to_ / "sub/data"), 1U);
}

/// Or a copy that root makes would run as root for everybody.
TEST_F(AnEntryFolder, IsCopiedWithoutSetUserId) {
  fs::permissions(from_ / "mouse.py", fs::perms::owner_all | fs::perms::set_uid | fs::perms::set_gid);
  EXPECT_EQ(copied(), "");
  EXPECT_EQ(fs::status(to_ / "mouse.py").permissions() & (fs::perms::set_uid | fs::perms::set_gid), fs::perms::none);
}

/// It would show a mouse the folder that it names.
TEST_F(AnEntryFolder, HasNoPythonEnvironment) {
  write("sub/pyvenv.cfg", "home = /home/ada/bin\n");
  EXPECT_NE(copied(), "");
  EXPECT_NE(hash_of_folder(from_.string()).error, "");
}

TEST_F(AnEntryFolder, HasAHashOfAllFiles) {
  const auto hash = [](const fs::path& folder) { return hash_of_folder(folder.string()).hash; };
  const std::string before = hash(from_);
  EXPECT_EQ(copied(), "");
  EXPECT_EQ(hash(to_), before);
  write("sub/data", "2");
  const std::string changed = hash(from_);
  EXPECT_NE(changed, before);
  fs::rename(from_ / "sub/data", from_ / "sub/date");
  const std::string renamed = hash(from_);
  EXPECT_NE(renamed, changed);
  fs::permissions(from_ / "sub/date", fs::perms::owner_exec, fs::perm_options::add);
  EXPECT_NE(hash(from_), renamed);
  fs::create_symlink("../../mouse.py", from_ / "sub/link");
  EXPECT_NE(hash_of_folder(from_.string()).error, "");
}

TEST_F(AnEntryFolder, HasNoLinks) {
  fs::create_symlink("../../from/mouse.py", from_ / "sub/link");
  EXPECT_NE(copied(), "");
  fs::remove(from_ / "sub/link");
  fs::create_directory_symlink("/", from_ / "all");
  EXPECT_NE(copied(), "");
}

TEST_F(AnEntryFolder, HasNoMoreBytesThanAllowed) {
  write("large", "");
  fs::resize_file(from_ / "large", most_entry_bytes - 8);
  EXPECT_EQ(copied(), "");
  fs::remove_all(to_);
  fs::resize_file(from_ / "large", most_entry_bytes - 7);
  EXPECT_NE(copied(), "");
}

TEST_F(AnEntryFolder, HasNoMoreFilesThanAllowed) {
  for (int i = 0; i < most_entry_files - 3; ++i) write("sub/f" + std::to_string(i), "");
  EXPECT_EQ(copied(), "");
  fs::remove_all(to_);
  write("one more", "");
  EXPECT_NE(copied(), "");
}

}  // namespace
}  // namespace labmouse
