#include "labmouse/lab/mice/external_identity.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "labmouse/external/capstone.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/system/files.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

class AnExternalMousesIdentity : public testing::Test {
 protected:
  AnExternalMousesIdentity() { fs::create_directories(folder_ / "other"); }
  ~AnExternalMousesIdentity() override { fs::remove_all(folder_); }

  void file(const std::string& name, const std::string& content) const { std::ofstream(folder_ / name) << content; }
  std::string identity(const std::string& command, const std::string& label = "",
                       const std::string& folder = "") const {
    ExternalOptions options;
    options.label = label;
    options.directory = (folder_ / folder).string();
    const SpecResult read = read_specs("program:" + command, options);
    EXPECT_EQ(read.error, "");
    return read.contestants.empty() ? "" : read.contestants.front().identity();
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("labmouse-identity-" + std::to_string(getpid()) + "-" +
                                                     testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(AnExternalMousesIdentity, FollowsItsFiles) {
  file("mouse.py", "one");
  const std::string first = identity("sh mouse.py");
  EXPECT_EQ(identity("sh mouse.py"), first);
  file("mouse.py", "two");
  EXPECT_NE(identity("sh mouse.py"), first);
  file("mouse.py", "one");
  EXPECT_EQ(identity("sh mouse.py"), first);
  // It may import what lies beside it.
  file("helper.py", "one");
  const std::string helped = identity("sh mouse.py");
  EXPECT_NE(helped, first);
  file("helper.py", "two");
  EXPECT_NE(identity("sh mouse.py"), helped);
  file("helper.py", "one");
  file("notes.txt", "no code");
  EXPECT_EQ(identity("sh mouse.py"), helped);
}

TEST_F(AnExternalMousesIdentity, FollowsWhatItsFilesName) {
  file("mouse.py", "from parts import eyes\nopen('weights.bin')\n");
  file("weights.bin", "one");
  fs::create_directories(folder_ / "parts");
  file("parts/eyes.py", "open('lens.json')");
  file("parts/lens.json", "one");
  file("results.db", "of labmouse");
  const std::string first = identity("sh mouse.py");
  EXPECT_EQ(identity("sh mouse.py"), first);
  for (const char* name : {"weights.bin", "parts/eyes.py", "parts/lens.json"}) {
    const std::string before = read_file((folder_ / name).string()).content;
    file(name, before + " ");
    EXPECT_NE(identity("sh mouse.py"), first) << name;
    file(name, before);
    EXPECT_EQ(identity("sh mouse.py"), first) << name;
  }
  file("results.db", "another one");
  file("other/mouse.py", "of another mouse");
  EXPECT_EQ(identity("sh mouse.py"), first);
}

TEST_F(AnExternalMousesIdentity, FollowsTheProgramThatRunsIt) {
  file("mouse.txt", "one");
  const auto runner = [&](const std::string& content) {
    file("run", content);
    fs::permissions(folder_ / "run", fs::perms::owner_all);
    return identity("\"" + (folder_ / "run").string() + "\" mouse.txt");
  };
  const std::string first = runner("#!/bin/sh\ncat $1\n");
  EXPECT_NE(runner("#!/bin/sh\ncat $1 $1\n"), first);
  EXPECT_EQ(runner("#!/bin/sh\ncat $1\n"), first);
  EXPECT_NE(program_identity((folder_ / "mouse.txt").string()), program_identity((folder_ / "run").string()));
}

TEST_F(AnExternalMousesIdentity, FollowsThePackagesOfItsPython) {
  file("mouse.py", "one");
  fs::create_directories(folder_ / "installed" / "maths-1.0.dist-info");
  const std::vector<std::string> environment = {"PYTHONPATH=" + (folder_ / "installed").string()};
  const std::string first = python_packages("python3", environment, false);
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(python_packages("python3", environment, false), first);
  fs::rename(folder_ / "installed" / "maths-1.0.dist-info", folder_ / "installed" / "maths-2.0.dist-info");
  EXPECT_NE(python_packages("python3", environment, false), first);
  EXPECT_NE(identity("python3 mouse.py").find("packages " + python_packages("python3", {}, false)), std::string::npos);
}

TEST_F(AnExternalMousesIdentity, IsTheSameInAnotherFolder) {
  file("mouse.py", "one");
  file("other/mouse.py", "one");
  EXPECT_EQ(identity("sh mouse.py"), identity("sh mouse.py", "", "other"));
  EXPECT_EQ(identity("sh mouse.py"), identity("sh \"" + (folder_ / "mouse.py").string() + "\""));
}

TEST_F(AnExternalMousesIdentity, FollowsItsWordsAndLimits) {
  file("mouse.py", "one");
  EXPECT_NE(identity("sh mouse.py"), identity("sh mouse.py fast"));
  EXPECT_NE(identity("sh mouse.py fast"), identity("sh mouse.py slow"));
  EXPECT_NE(identity("sh mouse.py"), identity("sh -u mouse.py"));
  Launch launch;
  launch.words = {"mouse"};
  const std::string first = external_identity("program", launch, {}, "");
  EXPECT_NE(external_identity("mms", launch, {}, ""), first);
  EXPECT_NE(external_identity("program", launch, Interpreter{"/bin/python3", "3.11.2"}, ""), first);
  EXPECT_NE(external_identity("program", launch, Interpreter{"/bin/python3", "3.11.2"}, ""),
            external_identity("program", launch, Interpreter{"/bin/python3", "3.12.1"}, ""));
  EXPECT_EQ(external_identity("program", launch, Interpreter{"/bin/python3", "3.11.2"}, ""),
            external_identity("program", launch, Interpreter{"/usr/bin/python3", "3.11.2"}, ""));
  Launch other = launch;
  other.environment = {"STYLE=fast"};
  EXPECT_NE(external_identity("program", other, {}, ""), first);
  other = launch;
  other.sandbox = true;
  const std::string boxed = external_identity("program", other, {}, "");
  EXPECT_NE(boxed, first);
  other.keeps_folder = true;
  EXPECT_NE(external_identity("program", other, {}, ""), boxed);
  other = launch;
  other.limits.decision += std::chrono::milliseconds(1);
  EXPECT_NE(external_identity("program", other, {}, ""), first);
}

TEST_F(AnExternalMousesIdentity, IsItsLabelInPlaceOfItsFiles) {
  file("mouse.py", "one");
  const std::string first = identity("sh mouse.py", "v1");
  EXPECT_NE(first, identity("sh mouse.py"));
  EXPECT_NE(first, identity("sh mouse.py", "v2"));
  file("mouse.py", "two");
  EXPECT_EQ(identity("sh mouse.py", "v1"), first);
}

}  // namespace
}  // namespace labmouse
