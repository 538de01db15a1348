// Contests of capstone robots that a test writes down.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/interpreters.hpp"

namespace labmouse::test {

/// Time enough on a machine that does much else; only a test that fails waits for it.
inline ExternalLimits patient() {
  ExternalLimits limits;
  limits.start = limits.decision = std::chrono::seconds(30);
  limits.contest = std::chrono::minutes(5);
  return limits;
}

/// Robots under one of the two Pythons, in a folder of their own.
class ARobot : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    options_.python = std::string(GetParam()) == "python3" ? python3() : python2();
    if (options_.python.empty()) GTEST_SKIP() << "no " << GetParam() << " that runs is in PATH";
    prepare();
  }
  ~ARobot() override { std::filesystem::remove_all(folder_); }

  void prepare() {
    options_.limits = patient();
    std::filesystem::create_directories(folder_);
  }

  std::string file(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }

  /// A contest of the robot in that file.
  RunRecord contest_of(const std::string& path, int budget, std::uint64_t seed = 1) const {
    static const Maze corridor = drawn(R"(
        o---o---o---o
        | S       G |
        o---o---o---o
    )");
    const SpecResult read = read_specs("capstone:" + path, options_);
    EXPECT_EQ(read.error, "");
    if (!read.error.empty()) return {};
    Rules rules;
    rules.budget = budget;
    const auto strategy = read.contestants.front().strategy(corridor, brief(corridor, rules, seed));
    return run(corridor, rules, *strategy);
  }

  /// A contest of a robot whose code this is.
  RunRecord contest(const std::string& code, int budget = 10) const {
    return contest_of(file("robot.py", unindented(code)), budget);
  }

  /// A contest of a robot whose next_move is these lines; `n` counts the calls from 1.
  RunRecord contest_by(const std::string& lines, int budget = 10) const {
    std::string code =
        "class Robot(object):\n    n = 0\n    def __init__(self, maze_dim):\n        self.dim = maze_dim\n"
        "    def next_move(self, sensors):\n        self.n += 1\n";
    std::istringstream text(unindented(lines));
    for (std::string line; std::getline(text, line);) code += "        " + line + "\n";
    return contest_of(file("robot.py", code), budget);
  }

  static std::vector<Action> actions(const RunRecord& record) {
    std::vector<Action> list;
    for (const StepRecord& step : record.steps) list.push_back(step.action);
    return list;
  }

  ExternalOptions options_;
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  ("labmouse-robot-" + std::to_string(getpid()) + "-" + std::string(GetParam()));
};

/// Robots that import numpy. A check that may not skip tests needs one.
class ARobotWithNumpy : public ARobot {
 protected:
  void SetUp() override {
    options_.python = python_with_numpy();
    if (options_.python.empty() && std::getenv("LABMOUSE_NO_SKIP") != nullptr)
      FAIL() << "no Python with numpy runs; `scripts/install ci` makes one in build/python";
    if (options_.python.empty()) GTEST_SKIP() << "no python3 in PATH has numpy (see `scripts/install ci`)";
    prepare();
  }
};

}  // namespace labmouse::test
