// The header for small chips makes the walks of `flood` and `flood-return`, and refuses what it must not do.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/firmware/tiny_in_c.h"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

/// A contest as both play it: the poses of both runs, the map at the end, and whether no route was left.
struct Walk {
  std::vector<Pose> poses;
  std::string map;
  bool no_route = false;

  friend bool operator==(const Walk&, const Walk&) = default;
};

void PrintTo(const Walk& walk, std::ostream* out) {
  for (const Pose& pose : walk.poses)
    *out << int{pose.cell.x} << ',' << int{pose.cell.y} << name_of(pose.heading).front() << ' ';
  *out << (walk.no_route ? "no route\n" : "\n") << walk.map;
}

std::string drawn(const Maze& maze, const Knowledge& knowledge) {
  MazeDraft draft(maze.size(), MazeDraft::Inside::closed);
  knowledge.possible().for_each([&](Wall wall) { draft.open(wall.cell, wall.side); });
  maze.goals().for_each([&](Cell cell) { draft.add_goal(cell); });
  return write_partial_map({Maze(draft), knowledge.unknown()}).content.value();
}

/// The strategy with moves of one cell and sensors that see the walls of one cell.
Walk walk_of(const BuiltinMouse& entry, const Maze& maze) {
  Briefing briefing = brief(maze, {.stride = 1}, 1);
  briefing.sight = 1;
  const Settings settings(entry.parameters);
  const auto mouse = entry.make(briefing, settings);
  Walk walk;
  Pose pose = briefing.start;
  for (bool racing = false, ended = false; !ended;) {
    walk.poses.push_back(pose);
    const Sighting far = look(maze, pose);
    const Action action = mouse->decide({std::min(far.left, 1), std::min(far.ahead, 1), std::min(far.right, 1)});
    walk.no_route = action.kind == Action::Kind::forfeit;
    ended = walk.no_route || (racing && maze.is_goal(pose.cell));
    racing = racing || action.kind == Action::Kind::reset;
    pose = action.kind == Action::Kind::reset ? briefing.start : after(pose, action);
  }
  walk.map = drawn(maze, mouse->knowledge());
  return walk;
}

Pose pose_of(const labmouse_tiny& mouse) { return {{mouse.x, mouse.y}, all_headings[mouse.heading]}; }

std::string printed;
int put(int letter) {
  printed += static_cast<char>(letter);
  return letter;
}

std::string map_of(const labmouse_tiny& mouse) {
  printed.clear();
  EXPECT_EQ(labmouse_tiny_print(&mouse, put), LABMOUSE_TINY_OK);
  return printed;
}

std::array<std::uint8_t, LABMOUSE_TINY_SAVED> eeprom;
void write_byte(std::uint16_t address, std::uint8_t byte) { eeprom.at(address) = byte; }
std::uint8_t read_byte(std::uint16_t address) { return eeprom.at(address); }

labmouse_tiny_status observe(const tiny_functions& tiny, labmouse_tiny& mouse, const Maze& maze) {
  const Sighting seen = look(maze, pose_of(mouse));
  return tiny.observe(&mouse, seen.left == 0, seen.ahead == 0, seen.right == 0);
}

/// Its run from the present pose until it ends.
void run_to_end(const tiny_functions& tiny, labmouse_tiny& mouse, const Maze& maze, Walk& walk) {
  for (labmouse_tiny_move move = LABMOUSE_TINY_AHEAD; move != LABMOUSE_TINY_END;) {
    const Pose before = pose_of(mouse);
    walk.poses.push_back(before);
    ASSERT_EQ(observe(tiny, mouse, maze), LABMOUSE_TINY_OK);
    const labmouse_tiny_status status = tiny.decide(&mouse, &move);
    walk.no_route = status == LABMOUSE_TINY_NO_ROUTE;
    if (walk.no_route) return;
    ASSERT_EQ(status, LABMOUSE_TINY_OK);
    const Pose now = pose_of(mouse);
    if (move == LABMOUSE_TINY_BACK) {
      EXPECT_EQ(now, (Pose{neighbour(before.cell, opposite(before.heading)), before.heading}));
    } else if (move == LABMOUSE_TINY_LOOK) {
      EXPECT_EQ(now, (Pose{before.cell, right_of(before.heading)}));
    } else if (move != LABMOUSE_TINY_END) {
      const Heading heading = turned(before.heading, move);
      EXPECT_EQ(now, (Pose{neighbour(before.cell, heading), heading}));
    }
    if (now.cell != before.cell) {
      ASSERT_EQ(maze.open_walls().contains(wall_at(before.cell, turned(before.heading, move))), true);
    }
  }
}

void set_goals(const tiny_functions& tiny, labmouse_tiny& mouse, const Maze& maze) {
  std::vector<std::array<std::uint8_t, 2>> cells;
  maze.goals().for_each([&](Cell cell) {
    cells.push_back({static_cast<std::uint8_t>(cell.x), static_cast<std::uint8_t>(cell.y)});
  });
  ASSERT_EQ(tiny.set_goals(&mouse, reinterpret_cast<const std::uint8_t(*)[2]>(cells.data()),
                           static_cast<std::uint8_t>(cells.size())),
            LABMOUSE_TINY_OK);
}

Walk walk_of(const tiny_functions& tiny, const Maze& maze, bool returns) {
  labmouse_tiny mouse;
  std::memset(&mouse, 0xA5, sizeof mouse);
  EXPECT_EQ(tiny.create(&mouse, returns), LABMOUSE_TINY_OK);
  if (maze.goals() != centre_of(maze.size())) set_goals(tiny, mouse, maze);
  Walk walk;
  run_to_end(tiny, mouse, maze, walk);
  if (!walk.no_route) {
    EXPECT_EQ(tiny.start(&mouse, 1), LABMOUSE_TINY_OK);
    run_to_end(tiny, mouse, maze, walk);
  }
  walk.map = map_of(mouse);
  return walk;
}

std::vector<Maze> builtin_mazes_of_16() {
  std::vector<Maze> mazes;
  for (const auto& entry : std::filesystem::directory_iterator(LABMOUSE_SOURCE_DIR "/mazes"))
    if (const auto maze = test::maze_in_file(entry.path()); maze && maze->size() == Size{16, 16})
      mazes.push_back(*maze);
  return mazes;
}

void expect_same_walks(const Maze& maze) {
  SCOPED_TRACE(test::drawing_of(maze));
  for (const bool returns : {false, true}) {
    const Walk walk = walk_of(returns ? flood_return_mouse : flood_mouse, maze);
    for (const tiny_functions* tiny : {&tiny_in_c, &tiny_in_cpp11}) ASSERT_EQ(walk_of(*tiny, maze, returns), walk);
  }
}

TEST(Tiny, WalksAsFloodInEveryBuiltinMaze) {
  const std::vector<Maze> mazes = builtin_mazes_of_16();
  EXPECT_EQ(mazes.size(), 13U);
  for (const Maze& maze : mazes) ASSERT_NO_FATAL_FAILURE(expect_same_walks(maze));
}

TEST(Tiny, WalksAsFloodToOtherGoalsAndWhereNoRouteIsLeft) {
  Rng rng(1);
  int without_route = 0;
  for (int i = 0; i < 200; ++i) {
    const Generator& generator = *all_generators()[static_cast<std::size_t>(rng.below(6))];
    Maze maze = generator.make({{16, 16}, rng.bits(), rng.below(400)});
    maze = test::marked_anywhere(maze, rng).with_start({0, 0}, Heading::north);
    if (i % 4 == 0) maze = test::cut(maze, rng);
    if (maze.is_goal({0, 0})) continue;
    ASSERT_NO_FATAL_FAILURE(expect_same_walks(maze));
    without_route += walk_of(tiny_in_c, maze, false).no_route ? 1 : 0;
  }
  EXPECT_GT(without_route, 10);
}

TEST(Tiny, EndsAtOnceInAGoalAtTheStart) {
  labmouse_tiny mouse;
  labmouse_tiny_create(&mouse, 1);
  const std::uint8_t goal[1][2] = {{0, 0}};
  ASSERT_EQ(labmouse_tiny_set_goals(&mouse, goal, 1), LABMOUSE_TINY_OK);
  ASSERT_EQ(labmouse_tiny_observe(&mouse, 1, 0, 1), LABMOUSE_TINY_OK);
  labmouse_tiny_move move = LABMOUSE_TINY_AHEAD;
  EXPECT_EQ(labmouse_tiny_decide(&mouse, &move), LABMOUSE_TINY_OK);
  EXPECT_EQ(move, LABMOUSE_TINY_END);
}

/// A mouse that has searched a maze and is at the start again.
labmouse_tiny searched(const Maze& maze) {
  labmouse_tiny mouse;
  labmouse_tiny_create(&mouse, 0);
  Walk walk;
  run_to_end(tiny_in_c, mouse, maze, walk);
  EXPECT_EQ(labmouse_tiny_start(&mouse, 1), LABMOUSE_TINY_OK);
  return mouse;
}

TEST(Tiny, LooksWhereTheWallBehindWasNotSeen) {
  labmouse_tiny mouse;
  labmouse_tiny_create(&mouse, 0);
  ASSERT_EQ(labmouse_tiny_turned(&mouse, 2), LABMOUSE_TINY_OK);
  ASSERT_EQ(labmouse_tiny_observe(&mouse, 1, 1, 1), LABMOUSE_TINY_OK);
  labmouse_tiny_move move = LABMOUSE_TINY_AHEAD;
  ASSERT_EQ(labmouse_tiny_decide(&mouse, &move), LABMOUSE_TINY_OK);
  EXPECT_EQ(move, LABMOUSE_TINY_LOOK);
  EXPECT_EQ(pose_of(mouse), (Pose{{0, 0}, Heading::west}));
  ASSERT_EQ(labmouse_tiny_observe(&mouse, 1, 1, 0), LABMOUSE_TINY_OK);
  ASSERT_EQ(labmouse_tiny_decide(&mouse, &move), LABMOUSE_TINY_OK);
  EXPECT_EQ(move, LABMOUSE_TINY_RIGHT);
  EXPECT_EQ(pose_of(mouse), (Pose{{0, 1}, Heading::north}));
}

TEST(Tiny, FinishesIfItTurnsInPlaceOfDrivingBackwards) {
  for (const Maze& maze : builtin_mazes_of_16()) {
    labmouse_tiny mouse;
    labmouse_tiny_create(&mouse, 1);
    for (const std::uint8_t speed : {0, 1}) {
      ASSERT_EQ(labmouse_tiny_start(&mouse, speed), LABMOUSE_TINY_OK);
      int moves = 0;
      for (labmouse_tiny_move move = LABMOUSE_TINY_AHEAD; move != LABMOUSE_TINY_END; ++moves) {
        ASSERT_LT(moves, 1000);
        ASSERT_EQ(observe(tiny_in_c, mouse, maze), LABMOUSE_TINY_OK);
        ASSERT_EQ(labmouse_tiny_decide(&mouse, &move), LABMOUSE_TINY_OK);
        if (move == LABMOUSE_TINY_BACK) {
          ASSERT_EQ(labmouse_tiny_turned(&mouse, 2), LABMOUSE_TINY_OK);
        }
      }
      EXPECT_EQ(maze.is_goal(pose_of(mouse).cell), speed == 1);
    }
  }
}

TEST(Tiny, RestoresWhatItSaved) {
  const Maze maze = builtin_mazes_of_16().front();
  labmouse_tiny before = searched(maze);
  ASSERT_EQ(labmouse_tiny_save(&before, write_byte), LABMOUSE_TINY_OK);
  labmouse_tiny mouse;
  labmouse_tiny_create(&mouse, 0);
  ASSERT_EQ(labmouse_tiny_restore(&mouse, read_byte), LABMOUSE_TINY_OK);
  EXPECT_EQ(map_of(mouse), map_of(before));
  Walk expected, walk;
  ASSERT_EQ(labmouse_tiny_start(&mouse, 1), LABMOUSE_TINY_OK);
  run_to_end(tiny_in_c, before, maze, expected);
  run_to_end(tiny_in_c, mouse, maze, walk);
  EXPECT_EQ(walk, expected);
}

void expect_refused() {
  labmouse_tiny mouse;
  std::memset(&mouse, 0, sizeof mouse);
  labmouse_tiny_create(&mouse, 0);
  const labmouse_tiny before = mouse;
  EXPECT_EQ(labmouse_tiny_restore(&mouse, read_byte), LABMOUSE_TINY_BAD_MAP);
  EXPECT_EQ(std::memcmp(&mouse, &before, sizeof mouse), 0);
}

TEST(Tiny, RefusesACorruptedMap) {
  const labmouse_tiny mouse = searched(builtin_mazes_of_16().front());
  labmouse_tiny_save(&mouse, write_byte);
  const auto saved = eeprom;
  for (std::size_t at = 0; at < saved.size(); ++at)
    for (unsigned bit = 1; bit < 256; bit *= 2) {
      eeprom = saved;
      eeprom.at(at) ^= static_cast<std::uint8_t>(bit);
      expect_refused();
    }
  for (const std::uint8_t erased : {0, 0xFF}) {
    eeprom.fill(erased);
    expect_refused();
  }
}

TEST(Tiny, RefusesAMapThatCannotBe) {
  for (int fault = 0; fault < 5; ++fault) {
    SCOPED_TRACE(fault);
    labmouse_tiny mouse;
    labmouse_tiny_create(&mouse, 0);
    if (fault == 0) mouse.sets[labmouse_tiny_possible][3] |= 0x8000;
    if (fault == 1) mouse.sets[labmouse_tiny_possible + 1][15] = 1;
    if (fault == 2) mouse.sets[labmouse_tiny_open][15] = 0x8000;
    if (fault == 3) mouse.sets[labmouse_tiny_open + 1][5] = 1, mouse.sets[labmouse_tiny_possible + 1][5] = 2;
    if (fault == 4) mouse.sets[labmouse_tiny_goals][7] = mouse.sets[labmouse_tiny_goals][8] = 0;
    labmouse_tiny_save(&mouse, write_byte);
    expect_refused();
  }
}

TEST(Tiny, RefusesNullPointers) {
  labmouse_tiny mouse;
  labmouse_tiny_create(&mouse, 0);
  labmouse_tiny_move move = LABMOUSE_TINY_AHEAD;
  const std::uint8_t goal[1][2] = {{1, 1}};
  const labmouse_tiny before = mouse;
  for (const labmouse_tiny_status status :
       {labmouse_tiny_create(nullptr, 0), labmouse_tiny_start(nullptr, 0), labmouse_tiny_set_goals(nullptr, goal, 1),
        labmouse_tiny_set_goals(&mouse, nullptr, 1), labmouse_tiny_observe(nullptr, 0, 0, 0),
        labmouse_tiny_decide(nullptr, &move), labmouse_tiny_decide(&mouse, nullptr), labmouse_tiny_turned(nullptr, 1),
        labmouse_tiny_print(nullptr, put), labmouse_tiny_print(&mouse, nullptr),
        labmouse_tiny_save(nullptr, write_byte), labmouse_tiny_save(&mouse, nullptr),
        labmouse_tiny_restore(nullptr, read_byte), labmouse_tiny_restore(&mouse, nullptr)})
    EXPECT_EQ(status, LABMOUSE_TINY_NULL);
  EXPECT_EQ(std::memcmp(&mouse, &before, sizeof mouse), 0);
}

TEST(Tiny, RefusesEverythingBeforeCreate) {
  labmouse_tiny mouse;
  labmouse_tiny_move move = LABMOUSE_TINY_AHEAD;
  const std::uint8_t goal[1][2] = {{1, 1}};
  for (const int memory : {0, 0x55, 0xFF}) {
    std::memset(&mouse, memory, sizeof mouse);
    for (const labmouse_tiny_status status :
         {labmouse_tiny_start(&mouse, 0), labmouse_tiny_set_goals(&mouse, goal, 1),
          labmouse_tiny_observe(&mouse, 0, 0, 0), labmouse_tiny_decide(&mouse, &move), labmouse_tiny_turned(&mouse, 1),
          labmouse_tiny_print(&mouse, put), labmouse_tiny_save(&mouse, write_byte),
          labmouse_tiny_restore(&mouse, read_byte)})
      EXPECT_EQ(status, LABMOUSE_TINY_ORDER);
  }
}

TEST(Tiny, RefusesAWrongOrderOfCalls) {
  labmouse_tiny mouse;
  labmouse_tiny_create(&mouse, 0);
  labmouse_tiny_move move = LABMOUSE_TINY_AHEAD;
  const std::uint8_t goal[1][2] = {{0, 1}};
  EXPECT_EQ(labmouse_tiny_set_goals(&mouse, goal, 1), LABMOUSE_TINY_OK);
  labmouse_tiny_save(&mouse, write_byte);
  EXPECT_EQ(labmouse_tiny_decide(&mouse, &move), LABMOUSE_TINY_ORDER);
  ASSERT_EQ(labmouse_tiny_observe(&mouse, 1, 0, 1), LABMOUSE_TINY_OK);
  EXPECT_EQ(labmouse_tiny_observe(&mouse, 1, 0, 1), LABMOUSE_TINY_ORDER);
  EXPECT_EQ(labmouse_tiny_turned(&mouse, 1), LABMOUSE_TINY_ORDER);
  EXPECT_EQ(labmouse_tiny_set_goals(&mouse, goal, 1), LABMOUSE_TINY_ORDER);
  EXPECT_EQ(labmouse_tiny_restore(&mouse, read_byte), LABMOUSE_TINY_ORDER);
  ASSERT_EQ(labmouse_tiny_decide(&mouse, &move), LABMOUSE_TINY_OK);
  EXPECT_EQ(move, LABMOUSE_TINY_AHEAD);
  EXPECT_EQ(labmouse_tiny_decide(&mouse, &move), LABMOUSE_TINY_ORDER);
  EXPECT_EQ(labmouse_tiny_restore(&mouse, read_byte), LABMOUSE_TINY_ORDER);
  ASSERT_EQ(labmouse_tiny_observe(&mouse, 1, 0, 1), LABMOUSE_TINY_OK);
  ASSERT_EQ(labmouse_tiny_decide(&mouse, &move), LABMOUSE_TINY_OK);
  EXPECT_EQ(move, LABMOUSE_TINY_END);
  EXPECT_EQ(labmouse_tiny_decide(&mouse, &move), LABMOUSE_TINY_ORDER);
  EXPECT_EQ(labmouse_tiny_observe(&mouse, 1, 0, 1), LABMOUSE_TINY_ORDER);
  EXPECT_EQ(labmouse_tiny_start(&mouse, 1), LABMOUSE_TINY_OK);
  EXPECT_EQ(labmouse_tiny_observe(&mouse, 1, 0, 1), LABMOUSE_TINY_OK);
}

TEST(Tiny, RefusesArgumentsOutOfRange) {
  labmouse_tiny mouse;
  labmouse_tiny_create(&mouse, 0);
  const labmouse_tiny before = mouse;
  const std::uint8_t right[2][2] = {{1, 1}, {16, 0}}, above[1][2] = {{0, 16}};
  for (const labmouse_tiny_status status :
       {labmouse_tiny_create(&mouse, 2), labmouse_tiny_start(&mouse, 2), labmouse_tiny_set_goals(&mouse, right, 2),
        labmouse_tiny_set_goals(&mouse, above, 1), labmouse_tiny_set_goals(&mouse, above, 0),
        labmouse_tiny_observe(&mouse, 2, 0, 0), labmouse_tiny_observe(&mouse, 1, 2, 0),
        labmouse_tiny_observe(&mouse, 1, 0, 2), labmouse_tiny_turned(&mouse, 4)})
    EXPECT_EQ(status, LABMOUSE_TINY_RANGE);
  EXPECT_EQ(std::memcmp(&mouse, &before, sizeof mouse), 0);
}

TEST(Tiny, RefusesReadingsThatContradictTheMap) {
  labmouse_tiny mouse;
  labmouse_tiny_create(&mouse, 0);
  const labmouse_tiny before = mouse;
  EXPECT_EQ(labmouse_tiny_observe(&mouse, 0, 0, 0), LABMOUSE_TINY_CONTRADICTION);  // the border in the west
  EXPECT_EQ(std::memcmp(&mouse, &before, sizeof mouse), 0);
  ASSERT_EQ(labmouse_tiny_observe(&mouse, 1, 0, 1), LABMOUSE_TINY_OK);
  labmouse_tiny_start(&mouse, 0);
  EXPECT_EQ(labmouse_tiny_observe(&mouse, 1, 1, 1), LABMOUSE_TINY_CONTRADICTION);
  EXPECT_EQ(labmouse_tiny_observe(&mouse, 1, 0, 0), LABMOUSE_TINY_CONTRADICTION);
  EXPECT_EQ(labmouse_tiny_observe(&mouse, 1, 0, 1), LABMOUSE_TINY_OK);
}

TEST(Tiny, HasNoRouteForASpeedRunBeforeTheGoalWasFound) {
  labmouse_tiny mouse;
  labmouse_tiny_create(&mouse, 0);
  labmouse_tiny_start(&mouse, 1);
  ASSERT_EQ(labmouse_tiny_observe(&mouse, 1, 0, 1), LABMOUSE_TINY_OK);
  labmouse_tiny_move move = LABMOUSE_TINY_AHEAD;
  EXPECT_EQ(labmouse_tiny_decide(&mouse, &move), LABMOUSE_TINY_NO_ROUTE);
}

}  // namespace
}  // namespace labmouse
