// A program on the whole library: every header, and something of each of them.
#include <cstdio>

#include "every_header.hpp"

namespace {

using namespace labmouse;

int failures = 0;

void check(bool holds, const char* what) {
  if (!holds) std::printf("does not hold: %s\n", what);
  failures += holds ? 0 : 1;
}

void mazes_are_made_written_read_and_inspected() {
  const Maze maze = find_generator("contest")->make({{16, 16}, 7, 0});
  const auto drawing = drawing_format.write(maze).content;
  check(drawing && read_maze(*drawing).maze == maze, "a maze survives being written");
  check(inspect(maze).shortest_strides.has_value(), "the goal can be reached");
  check(write_file("made.txt", *drawing).empty() && read_file("made.txt").content == *drawing, "files are kept");
  const std::vector<std::string> paths = {"made.txt", "contest-01"};
  check(load_mazes(paths).mazes.size() == 2, "files and built-in mazes are found");
}

void mice_run_and_leave_records() {
  const NamedMaze maze = load_builtin_mazes().mazes.front();
  const Rules rules;
  const SpecResult mice = read_specs("flood:stride=1,certify");
  check(mice.contestants.size() == 2 && builtin_mice().size() > 2, "mice are found");
  for (const Contestant& mouse : mice.contestants) {
    const auto strategy = mouse.strategy(maze.maze, brief(maze.maze, rules, 1));
    RecordFile file;
    file.maze_name = maze.name;
    file.maze = maze.maze;
    file.mouse = mouse.name;
    file.rules = rules;
    file.run = run(maze.maze, rules, *strategy);
    const Score result = score(file.run, rules);
    check(result.value >= bound_of(maze.maze, rules).score, "no score is below the bound");
    const ReadRecordResult read = read_record(write_record(file));
    check(read.file && replay(*read.file, maze.maze).disagreement.empty(), "a record can be played again");
  }
  check(draw_text(maze.maze, {}, false).find("o---o") != std::string::npos, "a maze is drawn as text");
  check(draw_svg(maze.maze, {}).starts_with("<svg"), "a maze is drawn as a picture");
}

void mice_drive_in_memory_that_is_given() {
  const FoundRobot robot = find_robot("mm2021");
  const Maze maze = load_builtin_mazes().mazes.front().maze;
  DriveRules rules;
  rules.time_limit = 300'000'000;
  std::vector<std::byte> memory(DriveFields::bytes_for(maze.size(), robot.model));
  DriveFields fields(maze.size(), robot.model, memory);
  Briefing briefing = brief(maze, rules, robot.model, 1);
  briefing.drive.fields = &fields;
  const BuiltinMouse* flood = find_mouse("flood");
  const auto strategy = flood->drive(briefing, Settings(flood->parameters));
  check(score(drive(maze, rules, robot.model, *strategy), rules).value().has_value(), "a mouse drives to the goal");
}

void knowledge_and_distances_follow_from_readings() {
  const Size size{3, 3};
  Knowledge knowledge(size);
  const Pose pose{{0, 0}, Heading::north};
  check(knowledge.learn(pose, Sighting{0, 2, 0}), "a first reading contradicts nothing");
  CellSet goals;
  goals.insert({0, 2});
  DistanceField field(size, strides(3));
  field.fill(knowledge.open(), goals);
  check(field.reaches({0, 0}), "what was seen open can be walked");
  Rng rng(7);
  check(rng.below(6) < 6, "a die falls");
}

}  // namespace

int main() {
  mazes_are_made_written_read_and_inspected();
  mice_run_and_leave_records();
  mice_drive_in_memory_that_is_given();
  knowledge_and_distances_follow_from_readings();
  std::printf("%d promises of the library are broken\n", failures);
  return failures == 0 ? 0 : 1;
}
