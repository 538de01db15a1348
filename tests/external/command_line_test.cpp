#include "labmouse/external/command_line.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace labmouse {
namespace {

using Words = std::vector<std::string>;

TEST(CommandLine, IsSplitAtBlanks) {
  EXPECT_EQ(split_command("python3 mouse.py  7"), (Words{"python3", "mouse.py", "7"}));
  EXPECT_EQ(split_command("\t a\n"), (Words{"a"}));
  EXPECT_EQ(split_command(" "), Words());
  EXPECT_EQ(split_command(""), Words());
}

TEST(CommandLine, HasQuotesThatGroup) {
  EXPECT_EQ(split_command(R"(run "my mouse" x"y z"w)"), (Words{"run", "my mouse", "xy zw"}));
  EXPECT_EQ(split_command(R"(a "" b)"), (Words{"a", "", "b"}));
  EXPECT_EQ(split_command(R"(say """hi""")"), (Words{"say", "\"hi\""}));
  EXPECT_EQ(split_command(R"(open "end)"), (Words{"open", "end"}));
}

TEST(CommandLine, KnowsNothingOfShells) {
  EXPECT_EQ(split_command("a $HOME 'b c' > d; e | f \\g"),
            (Words{"a", "$HOME", "'b", "c'", ">", "d;", "e", "|", "f", "\\g"}));
}

class Programs : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_ / "bin");
    for (const char* name : {"mouse", "bin/mouse", "plain"}) std::ofstream(folder_ / name) << "#!/bin/sh\n";
    for (const char* name : {"mouse", "bin/mouse"})
      std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all);
    before_ = std::getenv("PATH");
  }
  ~Programs() override {
    setenv("PATH", before_.c_str(), 1);
    std::filesystem::remove_all(folder_);
  }
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("labmouse-programs-" + std::to_string(getpid()));
  std::string before_;
};

TEST_F(Programs, AreLookedForInPath) {
  setenv("PATH", ("/nowhere:" + folder_.string() + ":" + (folder_ / "bin").string()).c_str(), 1);
  EXPECT_EQ(program_path("mouse", ""), (folder_ / "mouse").string());
  EXPECT_EQ(program_path("plain", ""), "") << "cannot be executed";
  EXPECT_EQ(program_path("bin", ""), "") << "is a folder";
  EXPECT_EQ(program_path("other", ""), "");
  EXPECT_EQ(program_path("", ""), "");
}

TEST(OpenQuotes, AreFound) {
  for (const char* open : {"a \"b", "\"", "a \"b c\" \"", "\"\"\"\"", "a\"\"\" \"b"})
    EXPECT_TRUE(has_open_quote(open)) << open;
  for (const char* closed : {"", "a b", "a \"b c\"", "\"\"", "\"\"\"", "a \"\"\"b", "\"a \"\"\" b\""})
    EXPECT_FALSE(has_open_quote(closed)) << closed;
}

TEST_F(Programs, WithASlashAreSeenFromTheirFolder) {
  EXPECT_EQ(program_path("./mouse", folder_.string()), "./mouse");
  EXPECT_EQ(program_path("bin/mouse", folder_.string()), "bin/mouse");
  EXPECT_EQ(program_path("./plain", folder_.string()), "");
  EXPECT_EQ(program_path((folder_ / "mouse").string(), "/"), (folder_ / "mouse").string());
}

}  // namespace
}  // namespace labmouse
