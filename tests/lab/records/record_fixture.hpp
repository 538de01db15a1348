// Records to test with.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/replays/steps_text.hpp"
#include "labmouse/lab/steps/steps_files.hpp"
#include "tests/lab/races/race_fixture.hpp"

namespace labmouse::test {

/// The record of a mouse in a maze, as a file; with its reasons where they are asked for.
inline RecordFile recorded(std::string_view spec, const NamedMaze& maze = loop(), std::uint64_t seed = 1,
                           bool reasons = false) {
  const Contestant mouse = mice(spec).front();
  Briefing briefing = brief(maze.maze, {}, seed);
  briefing.reasons = reasons;
  const auto strategy = mouse.strategy(maze.maze, briefing);
  return record_file_of(mouse, maze, Rules(), seed, run(maze.maze, Rules(), *strategy));
}

inline RecordFile read(const std::string& text) {
  ReadRecordResult result = read_record(text);
  if (!result.file) ADD_FAILURE() << result.problems.front().line << ": " << result.problems.front().reason;
  return result.file ? *result.file : RecordFile();
}

inline Problem problem(const std::string& text) {
  const ReadRecordResult result = read_record(text);
  EXPECT_FALSE(result.file.has_value());
  EXPECT_FALSE(result.problems.empty());
  return result.problems.empty() ? Problem() : result.problems.front();
}

/// The text with the first `from` replaced, which must be there.
inline std::string changed(std::string text, std::string_view from, std::string_view to) {
  const auto at = text.find(from);
  if (at == std::string::npos) ADD_FAILURE() << "the record has no " << from << ":\n" << text;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace labmouse::test
