#include "labmouse/lab/mice/guest_identity.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "labmouse/lab/mice/specs.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

class AGuestsIdentity : public testing::Test {
 protected:
  AGuestsIdentity() { fs::create_directories(folder_ / "other"); }
  ~AGuestsIdentity() override { fs::remove_all(folder_); }

  void file(const std::string& name, const std::string& content) const { std::ofstream(folder_ / name) << content; }
  std::string identity(const std::string& command, const std::string& label = "",
                       const std::string& folder = "") const {
    GuestOptions options;
    options.label = label;
    options.directory = (folder_ / folder).string();
    const SpecResult read = read_specs("guest:" + command, options);
    EXPECT_EQ(read.error, "");
    return read.contestants.empty() ? "" : read.contestants.front().identity();
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("labmouse-identity-" + std::to_string(getpid()) + "-" +
                                                     testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(AGuestsIdentity, FollowsItsFiles) {
  file("mouse.py", "one");
  const std::string first = identity("python3 mouse.py");
  EXPECT_EQ(identity("python3 mouse.py"), first);
  file("mouse.py", "two");
  EXPECT_NE(identity("python3 mouse.py"), first);
  file("mouse.py", "one");
  EXPECT_EQ(identity("python3 mouse.py"), first);
  // It may import what lies beside it.
  file("helper.py", "one");
  const std::string helped = identity("python3 mouse.py");
  EXPECT_NE(helped, first);
  file("helper.py", "two");
  EXPECT_NE(identity("python3 mouse.py"), helped);
  file("helper.py", "one");
  file("notes.txt", "no code");
  EXPECT_EQ(identity("python3 mouse.py"), helped);
}

TEST_F(AGuestsIdentity, IsTheSameInAnotherFolder) {
  file("mouse.py", "one");
  file("other/mouse.py", "one");
  EXPECT_EQ(identity("python3 mouse.py"), identity("python3 mouse.py", "", "other"));
  EXPECT_EQ(identity("python3 mouse.py"), identity("python3 \"" + (folder_ / "mouse.py").string() + "\""));
}

TEST_F(AGuestsIdentity, FollowsItsWordsAndLimits) {
  file("mouse.py", "one");
  EXPECT_NE(identity("python3 mouse.py"), identity("python3 mouse.py fast"));
  EXPECT_NE(identity("python3 mouse.py fast"), identity("python3 mouse.py slow"));
  EXPECT_NE(identity("python3 mouse.py"), identity("python3 -u mouse.py"));
  Launch launch;
  launch.words = {"mouse"};
  const std::string first = guest_identity("guest", launch, {}, "");
  EXPECT_NE(guest_identity("mms", launch, {}, ""), first);
  EXPECT_NE(guest_identity("guest", launch, Interpreter{"/bin/python3", "3.11.2"}, ""), first);
  EXPECT_NE(guest_identity("guest", launch, Interpreter{"/bin/python3", "3.11.2"}, ""),
            guest_identity("guest", launch, Interpreter{"/bin/python3", "3.12.1"}, ""));
  EXPECT_EQ(guest_identity("guest", launch, Interpreter{"/bin/python3", "3.11.2"}, ""),
            guest_identity("guest", launch, Interpreter{"/usr/bin/python3", "3.11.2"}, ""));
  Launch other = launch;
  other.environment = {"STYLE=fast"};
  EXPECT_NE(guest_identity("guest", other, {}, ""), first);
  other = launch;
  other.sandbox = true;
  const std::string boxed = guest_identity("guest", other, {}, "");
  EXPECT_NE(boxed, first);
  other.keeps_folder = true;
  EXPECT_NE(guest_identity("guest", other, {}, ""), boxed);
  other = launch;
  other.limits.decision += std::chrono::milliseconds(1);
  EXPECT_NE(guest_identity("guest", other, {}, ""), first);
}

TEST_F(AGuestsIdentity, IsItsLabelInPlaceOfItsFiles) {
  file("mouse.py", "one");
  const std::string first = identity("python3 mouse.py", "v1");
  EXPECT_NE(first, identity("python3 mouse.py"));
  EXPECT_NE(first, identity("python3 mouse.py", "v2"));
  file("mouse.py", "two");
  EXPECT_EQ(identity("python3 mouse.py", "v1"), first);
}

}  // namespace
}  // namespace labmouse
