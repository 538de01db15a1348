// Records of mms to test with.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/records/mms_record.hpp"
#include "tests/lab/mms/mms_fixture.hpp"

namespace labmouse::test {

/// The record of a program that writes those lines and ends.
inline std::string mms_recorded(const std::vector<std::string>& lines, std::int64_t most = most_recorded_events,
                                const NamedMaze& maze = plank()) {
  MmsHost host(maze.maze, {});
  MmsRecorder recorder("mms:./mouse", maze, most);
  host.on_event([&](const MmsEvent& event) { recorder.add(event); });
  std::string replies;
  for (const std::string& line : lines) host.obey(line, replies);
  MmsRun run;
  run.end = "exit code 0";
  run.statistics = host.statistics();
  run.clock = host.clock();
  run.lines = host.lines();
  run.invalid_lines = host.invalid_lines();
  return recorder.finish(run);
}

}  // namespace labmouse::test
