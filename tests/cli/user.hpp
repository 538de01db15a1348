// A user of the program, for tests that run it from end to end.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"
#include "tests/says.hpp"

namespace labmouse::test {

/// A user in an empty folder.
class AUser : public testing::Test {
 protected:
  AUser() { std::filesystem::create_directories(folder_); }
  ~AUser() override { std::filesystem::remove_all(folder_); }

  Ended labmouse(std::vector<std::string> arguments, const char* variable = nullptr) const {
    return Program(folder_, std::move(arguments), variable).wait();
  }
  /// Bad usage or input: exit code 2, one line on standard error, which has these parts, nothing on standard output.
  template <typename... Parts>
  void is_refused(std::vector<std::string> arguments, Parts... parts) const {
    const Ended ended = labmouse(std::move(arguments));
    EXPECT_EQ(ended.code, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_THAT(ended.err, Says(parts...));
  }
  nlohmann::json race(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"race", "--format", "json"});
    const Ended ended = labmouse(std::move(arguments));
    EXPECT_EQ(ended.code, 0) << ended.err;
    return nlohmann::json::parse(ended.out, nullptr, false);
  }
  std::string file(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return name;
  }
  std::string content(const std::string& name) const { return content_of(folder_ / name); }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("labmouse-cli-" + std::to_string(getpid()) + "-" +
                                                testing::UnitTest::GetInstance()->current_test_info()->name());
};

inline constexpr const char* corridor = "o---o---o---o\n| S       G |\no---o---o---o\n";

}  // namespace labmouse::test
