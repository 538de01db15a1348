// The capstone world a second time, from its description alone and as plainly as it can be written. The maze is a
// floor of characters, one for each cell, each wall and each post:
//
//     #######     A mouse in cell (x,y) stands at line 2y+1, column 2x+1, the southernmost line first. '#' is a wall
//     #. .#.#     or a post, '.' a cell, ' ' a passage between two cells. One cell further is two characters further.
//     #######
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/action.hpp"

namespace labmouse::test {

/// One step as the plain simulator sees it.
struct PlainStep {
  bool speed_run = false;
  int clock = 0;
  int x = 0, y = 0;
  char heading = 'n';
  int left = 0, ahead = 0, right = 0;
  bool blocked = false;
};

struct PlainContest {
  std::vector<PlainStep> steps;
  std::string outcome;
  int x = 0, y = 0;
  char heading = 'n';
};

class PlainSimulator {
 public:
  PlainSimulator(const Maze& maze, int budget, int stride) : budget_(budget), stride_(stride) {
    const int width = maze.size().width, height = maze.size().height;
    floor_.assign(static_cast<std::size_t>(2 * height + 1), std::string(static_cast<std::size_t>(2 * width + 1), '#'));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        at(2 * x + 1, 2 * y + 1) = maze.is_goal({x, y}) ? 'G' : '.';
        if (maze.is_open({x, y}, Heading::north)) at(2 * x + 1, 2 * y + 2) = ' ';
        if (maze.is_open({x, y}, Heading::east)) at(2 * x + 2, 2 * y + 1) = ' ';
      }
    start_x_ = maze.start().x;
    start_y_ = maze.start().y;
    start_heading_ = compass[static_cast<std::size_t>(maze.start_heading())];
  }

  /// Plays the actions in order; the list must be long enough for the contest to end.
  PlainContest play(const std::vector<Action>& actions) {
    PlainContest contest;
    go_to_start(contest);
    bool goal_entered = false, speed_run = false;
    int clock = 0;
    for (const Action& action : actions) {
      clock = clock + 1;
      if (clock > budget_) {
        contest.outcome = speed_run ? "speed run unfinished" : goal_entered ? "never reset" : "out of steps";
        return contest;
      }
      contest.steps.push_back({speed_run, clock, contest.x, contest.y, contest.heading, look(contest, 'l'),
                               look(contest, 'a'), look(contest, 'r'), false});
      if (action.kind == Action::Kind::forfeit) {
        contest.outcome = "forfeit";
        return contest;
      }
      if (action.kind == Action::Kind::reset) {
        if (goal_entered && !speed_run) {
          speed_run = true;
          go_to_start(contest);
        }
        continue;
      }
      contest.steps.back().blocked = step(contest, action.rotation, action.movement);
      if (at(2 * contest.x + 1, 2 * contest.y + 1) == 'G') {
        if (speed_run) {
          contest.outcome = "finished";
          return contest;
        }
        goal_entered = true;
      }
    }
    contest.outcome = "not over";
    return contest;
  }

 private:
  static constexpr const char* compass = "nesw";

  char& at(int column, int line) { return floor_[static_cast<std::size_t>(line)][static_cast<std::size_t>(column)]; }

  void go_to_start(PlainContest& contest) const {
    contest.x = start_x_;
    contest.y = start_y_;
    contest.heading = start_heading_;
  }

  static char left_turn(char heading) {
    return heading == 'n' ? 'w' : heading == 'w' ? 's' : heading == 's' ? 'e' : 'n';
  }
  static char right_turn(char heading) {
    return heading == 'n' ? 'e' : heading == 'e' ? 's' : heading == 's' ? 'w' : 'n';
  }

  /// Moves one cell, or does not and says so where a wall is in the way.
  bool move_one(int& x, int& y, char heading) {
    const int dx = heading == 'e' ? 1 : heading == 'w' ? -1 : 0;
    const int dy = heading == 'n' ? 1 : heading == 's' ? -1 : 0;
    if (at(2 * x + 1 + dx, 2 * y + 1 + dy) == '#') return false;
    x += dx;
    y += dy;
    return true;
  }

  int look(const PlainContest& contest, char side) {
    const char heading = side == 'l'   ? left_turn(contest.heading)
                         : side == 'r' ? right_turn(contest.heading)
                                       : contest.heading;
    int x = contest.x, y = contest.y, cells = 0;
    while (move_one(x, y, heading)) ++cells;
    return cells;
  }

  /// Whether a wall cut the step short.
  bool step(PlainContest& contest, int rotation, int movement) {
    if (rotation == 90) contest.heading = right_turn(contest.heading);
    if (rotation == -90) contest.heading = left_turn(contest.heading);
    if (movement > stride_) movement = stride_;
    if (movement < -stride_) movement = -stride_;
    char direction = contest.heading;
    if (movement < 0) {
      direction = left_turn(left_turn(direction));
      movement = -movement;
    }
    for (int cell = 0; cell < movement; ++cell)
      if (!move_one(contest.x, contest.y, direction)) return true;
    return false;
  }

  std::vector<std::string> floor_;
  int start_x_ = 0, start_y_ = 0;
  char start_heading_ = 'n';
  int budget_;
  int stride_;
};

}  // namespace labmouse::test
