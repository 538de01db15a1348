// Exchanges with the simulator of mms: lines in, replies out.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/external/line_buffer.hpp"
#include "labmouse/external/mms/host.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse::test {

/// 16×16 cells without a wall inside.
inline const Maze& field() {
  static const Maze maze{MazeDraft({16, 16}, MazeDraft::Inside::open)};
  return maze;
}

/// 3×3 cells; its goal is (1,1), whatever it marks.
inline const Maze& corner() {
  static const Maze maze = drawn(R"(
    o---o---o---o
    |       |   |
    o   o   o   o
    |   |       |
    o   o---o   o
    |   |     G |
    o---o---o---o
  )");
  return maze;
}

/// Three cells by two, without a wall inside.
inline const Maze& plank() {
  static const Maze maze{MazeDraft({3, 2}, MazeDraft::Inside::open)};
  return maze;
}

/// One cell.
inline const Maze& box() {
  static const Maze maze{MazeDraft({1, 1}, MazeDraft::Inside::closed)};
  return maze;
}

/// Obeys lines, each ended by \n, as they come from a program; the replies with blanks for their ends.
inline std::string told(MmsHost& host, std::string_view lines) {
  LineBuffer buffer(4096);
  buffer.append(lines);
  std::string replies;
  while (const auto line = buffer.next()) host.obey(*line, replies);
  if (!replies.empty()) replies.pop_back();
  for (char& letter : replies)
    if (letter == '\n') letter = ' ';
  return replies;
}

inline std::string words_of(const HalfPose& pose) {
  return "(" + std::to_string(pose.place.x) + "," + std::to_string(pose.place.y) + ") " +
         std::string(name_of(pose.heading));
}

/// One rule of the protocol. `name` says it.
struct Rule {
  const char* name;
  const Maze& (*maze)();
  /// Without the last line's end.
  const char* lines;
  const char* replies;
  /// Afterwards, or null where the rule does not speak of it.
  const char* pose = nullptr;
};

inline void PrintTo(const Rule& rule, std::ostream* out) { *out << rule.lines; }

inline std::string name_of_rule(const testing::TestParamInfo<Rule>& info) { return info.param.name; }

/// Expects the replies and the place that a rule says.
inline void expect(const Rule& rule) {
  MmsHost host(rule.maze(), {});
  EXPECT_EQ(told(host, std::string(rule.lines) + "\n"), rule.replies);
  if (rule.pose != nullptr) {
    EXPECT_EQ(words_of(host.pose()), rule.pose);
  }
}

}  // namespace labmouse::test
