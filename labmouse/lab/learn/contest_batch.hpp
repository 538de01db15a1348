// Many contests of the world of steps, stepped together, for strategies that learn by playing.
//
// Each contest is that of contest/simulator, step for step: the same rules, readings, outcomes and scores. Choices go
// in by their numbers (choices.hpp); what a learner observes comes out, into memory of the caller. A step takes no
// memory of its own, except that a contest in a maze that is made for it takes what the generator does.
//
// Rewards: -1 / search_factor for each step of the search run (the reset's is one), -1 for each of the speed run.
// The last reward of a contest makes their sum, added in order as doubles, minus the score to the last bit, or minus
// failure_score where the contest failed; that of a finished contest is -1 but for 1e-9. A contest fails when its steps
// are used up, which belongs to the rules: so it ends, and is never cut off.
//
// Contests restart by themselves: the step after the last of a contest ignores the choice, begins the next contest,
// pays 0 and shows its first observation (Gymnasium calls it AutoresetMode.NEXT_STEP).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "labmouse/chance/dice.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/learn/belief.hpp"
#include "labmouse/lab/learn/choices.hpp"
#include "labmouse/lab/learn/corridor_table.hpp"
#include "labmouse/lab/learn/maze_family.hpp"

namespace labmouse {

/// The columns of a contest's row: the sighting, the pose, and the briefing.
enum class RowColumn : std::uint8_t {
  left,          ///< open cells to the left,
  ahead,         ///< ahead
  right,         ///< and to the right, up to the next wall
  x,             ///< the mouse's cell
  y,             ///< counts northwards
  heading,       ///< 0 north, 1 east, 2 south, 3 west
  speed_run,     ///< 1 in the speed run, 0 in the search run
  goal_entered,  ///< 1 once a step of the search run ended in a goal
  steps_left,    ///< steps that are left over both runs
  blocked,       ///< 1 where a wall ended the last movement early
  width,         ///< of the maze
  height,
  goal_west,  ///< the smallest rectangle around the goals
  goal_south,
  goal_east,
  goal_north,
};
inline constexpr int row_columns = 16;

/// How a contest of a batch stands. From `finished` on it has ended; the names are those of Outcome.
enum class ContestState : std::uint8_t { running, finished, out_of_steps, never_reset, speed_run_unfinished };

/// Where a batch of n contests writes. What is empty is not written; at most one of words and bytes has memory. The
/// belief is kept nowhere else, and the rows are changed in place: nobody but the batch may write there.
struct BatchMemory {
  std::span<std::int16_t> rows;          ///< n x row_columns
  std::span<std::uint16_t> words;        ///< n x height x width: belief.hpp
  std::span<std::uint8_t> bytes;         ///< n x height x width x belief_planes: belief.hpp
  std::span<std::int8_t> masks;          ///< n x choice_count: 1 where a choice is valid
  std::span<double> rewards;             ///< n: of the last step
  std::span<double> returns;             ///< n, required: sum of the rewards of the contest so far
  std::span<std::uint8_t> ended;         ///< n, required: 1 where the last step ended the contest
  std::span<std::uint8_t> states;        ///< n: ContestState
  std::span<std::int64_t> maze_numbers;  ///< n: which maze of the list or of the family
};

/// Which maze a contest gets: one drawn by its own dice, or in turn: of n contests the i-th plays mazes i, i + n, i +
/// 2n, ..., and begins again after the last.
enum class MazeOrder : std::uint8_t { drawn, in_turn };

class ContestBatch {
 public:
  /// `count` contests (1 or more) in mazes of a list (not empty) or of a family that is not refused. The stride of the
  /// rules must be longest_choice, the budget 1 to 32767.
  ContestBatch(int count, std::span<const Maze> mazes, MazeOrder order, const Rules& rules = {});
  ContestBatch(int count, const MazeFamily& family, MazeOrder order, const Rules& rules = {});

  int count() const { return static_cast<int>(contests_.size()); }
  /// The largest width and height of its mazes: those of the planes.
  Size size() const { return size_; }
  /// What a batch itself holds for each contest, in bytes; mazes of a list are held once for all.
  std::size_t bytes_a_contest() const;

  /// Where to write from now on; the memory must outlive the batch. To be followed by start().
  void bind(const BatchMemory& memory);

  /// From which seed a contest draws its mazes. Equal seeds give equal contests, whatever the others are.
  void seed(int contest, std::uint64_t seed);

  /// Asked before each maze that has to be made, which takes longer than all else. Where it is true the contest stays
  /// ended, and begins with a later step.
  using Stop = std::function<bool()>;

  /// Begins a new contest everywhere, or where `which` is not 0; their rewards are 0.
  void start(const Stop& stop = {});
  void start(std::span<const std::uint8_t> which, const Stop& stop = {});

  /// One step of every contest. False, and nothing was done, where a choice is out of range.
  [[nodiscard]] bool step(std::span<const std::int64_t> choices, const Stop& stop = {});

  /// Draws a valid choice for each contest, each as likely as the others (to 2^-32).
  void draw_valid_choices(Dice& dice, std::span<std::int64_t> choices) const;

 private:
  struct Contest {
    Dice dice{0};
    std::uint64_t played = 0;  // contests begun
    std::uint32_t slot = 0;    // its maze's table
    std::int16_t clock = 0;
    std::int16_t explored = 0;  // steps of the search run
    std::uint8_t x = 0, y = 0, heading = 0;
    std::uint8_t moved = 0, direction = 0;  // by the last step
    bool blocked = false, speed_run = false, goal_entered = false;
    std::uint8_t choice_case = 0;
    bool ended = false;
  };
  /// What a mouse knows of a maze before the contest.
  struct Facts {
    std::int16_t width, height, start_x, start_y, start_heading;
    std::int16_t goal_west, goal_south, goal_east, goal_north;
  };

  ContestBatch(int count, Size size, std::size_t slots, MazeOrder order, const Rules& rules);
  void set_slot(std::size_t slot, const Maze& maze);
  std::uint64_t next_maze(std::size_t contest);
  void begin(std::size_t contest, const Stop& stop);
  void play(std::size_t contest, int choice);
  void move(Contest& contest, int choice) const;
  void settle(std::size_t contest, int choice, bool in_speed_run);
  void observe(std::size_t contest);
  void prefetch(std::size_t contest) const;
  void write_row(std::size_t contest, Sighting seen);
  template <class Form>
  void begin_belief(const Contest& contest, typename Form::Unit* cells) const;
  template <class Form>
  void change_belief(const Contest& contest, const Contest& before, typename Form::Unit* cells) const;
  template <class Form>
  void see(const Contest& contest, typename Form::Unit* cells) const;
  template <class Form>
  void add_everywhere(const Contest& contest, BeliefBits bits, typename Form::Unit* cells) const;
  template <class Write>
  void with_belief(std::size_t contest, Write write);

  std::size_t area() const { return static_cast<std::size_t>(size_.area()); }
  std::size_t place(const Contest& contest) const {
    return static_cast<std::size_t>(contest.y) * static_cast<std::size_t>(size_.width) + contest.x;
  }
  Corridors corridors(const Contest& contest) const { return tables_[contest.slot * area() + place(contest)]; }

  Rules rules_;
  double search_reward_;
  Size size_;
  MazeOrder order_;
  std::uint64_t maze_count_ = 0;  // 0: endless
  MazeFamily family_;
  bool listed_ = false;
  std::vector<Corridors> tables_;  // area() words for each slot
  std::vector<Facts> facts_;       // one for each slot
  std::vector<Contest> contests_;
  BatchMemory memory_;
};

/// What a step of the search run pays: -1 / search_factor, rounded to a multiple of 2^-40. So no sum of a contest
/// is rounded, and the last reward can make it the score to the last bit.
double search_reward(const Rules& rules);

}  // namespace labmouse
