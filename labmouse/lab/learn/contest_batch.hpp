// Vectorized contests of the world of steps, for reinforcement learning.
//
// Each contest equals that of contest/simulator, step by step: the same rules, readings, outcomes and scores. Actions
// are the numbers of choices.hpp; observations are written to memory of the caller. A step allocates nothing, except
// where it generates the maze of a new contest.
//
// Rewards: -1 / search_factor for each step of the search run (including the reset), -1 for each of the speed run. The
// last reward is chosen so that their sum, added in order as doubles, is exactly minus the score, or minus
// failure_score if the contest failed. If it finished, that reward is -1 within 1e-9. A contest fails when the step
// budget is used up. That is a rule of the game, so it is a termination, never a truncation.
//
// Contests restart by themselves: the step after the last of a contest ignores the choice and begins the next contest,
// with reward 0 and its first observation (Gymnasium's AutoresetMode.NEXT_STEP).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "labmouse/chance/rng.hpp"
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
  steps_left,    ///< remaining steps of the budget for both runs
  blocked,       ///< 1 where a wall ended the last movement early
  width,         ///< of the maze
  height,
  goal_west,  ///< the smallest rectangle around the goals
  goal_south,
  goal_east,
  goal_north,
};
inline constexpr int row_columns = 16;

/// The state of a contest. From `finished` on it has ended; the names are those of Outcome.
enum class ContestState : std::uint8_t { running, finished, out_of_steps, never_reset, speed_run_unfinished };

/// Memory for the output of a batch of n contests. Empty spans are not written; at most one of words and bytes may be
/// nonempty. The batch updates rows and planes in place and has no copy, so nobody else may write there.
struct BatchMemory {
  std::span<std::int16_t> rows;          ///< n x row_columns
  std::span<std::uint16_t> words;        ///< n x height x width: belief.hpp
  std::span<std::uint8_t> bytes;         ///< n x height x width x belief_planes: belief.hpp
  std::span<std::int8_t> masks;          ///< n x choice_count: 1 where a choice is valid
  std::span<double> rewards;             ///< n: of the last step
  std::span<double> returns;             ///< n, required: sum of the rewards of the contest so far
  std::span<std::uint8_t> ended;         ///< n, required: 1 where the last step ended the contest
  std::span<std::uint8_t> states;        ///< n: ContestState
  std::span<std::int64_t> maze_numbers;  ///< n: number of the maze in the list or the family
};

/// Which mazes a contest gets: drawn by its own random generator; or in turn, so that contest i of n plays the mazes
/// i, i + n, i + 2n, ..., modulo their number.
enum class MazeOrder : std::uint8_t { drawn, in_turn };

class ContestBatch {
 public:
  /// `count` contests (1 or more) in mazes of a list (not empty), or of a family for which refuses() returns an empty
  /// text. `rules.stride` must be longest_choice, `rules.budget` 1 to 32767.
  ContestBatch(int count, std::span<const Maze> mazes, MazeOrder order, const Rules& rules = {});
  ContestBatch(int count, const MazeFamily& family, MazeOrder order, const Rules& rules = {});

  int count() const { return static_cast<int>(contests_.size()); }
  /// The largest width and the largest height of its mazes, which the planes have.
  Size size() const { return size_; }
  /// Memory of the batch per contest, in bytes, without the mazes of a list, which all contests share.
  std::size_t bytes_a_contest() const;

  /// Sets the output memory, which must outlive the batch. Call start() afterwards.
  void bind(const BatchMemory& memory);

  /// Sets the seed by which a contest draws its mazes. Equal seeds give equal contests, independent of the other
  /// contests.
  void seed(int contest, std::uint64_t seed);

  /// Called before each generation of a maze, the slowest operation. If it returns true, the contest stays ended and
  /// begins with a later step.
  using Stop = std::function<bool()>;

  /// Begins new contests: all, or those for which `which` is not 0. Their rewards are 0.
  void start(const Stop& stop = {});
  void start(std::span<const std::uint8_t> which, const Stop& stop = {});

  /// One step of every contest. Returns false, without any change, if a choice is out of range.
  [[nodiscard]] bool step(std::span<const std::int64_t> choices, const Stop& stop = {});

  /// Draws a valid choice for each contest, uniformly (within 2^-32).
  void draw_valid_choices(Rng& rng, std::span<std::int64_t> choices) const;

 private:
  struct Contest {
    Rng rng{0};
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
  /// Properties of a maze that its mouse knows before the contest.
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

/// Reward of a step of the search run: -1 / search_factor, rounded to a multiple of 2^-40. So sums of rewards are
/// exact, and the last reward can make the sum exactly minus the score.
double search_reward(const Rules& rules);

}  // namespace labmouse
