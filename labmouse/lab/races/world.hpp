// A world, as a value: what one contest is, what it is scored by, which figures it has, what bounds it, and what of it
// is kept. Races, standings, tables, JSON, CSV, studies, reports and the page know no more of any world than this.
// docs/how-to/add-a-world.md builds one.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/grid/cell_set.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/lab/races/figures.hpp"
#include "labmouse/lab/races/world_setting.hpp"

namespace labmouse {

/// Names of figures that a world may have, and that have one meaning in all: the shares of the reachable cells that the
/// mouse came to know and stood in while it searched, 0 to 1; and what the mouse had to say.
inline constexpr std::string_view discovered_share = "discovered_share";
inline constexpr std::string_view visited_share = "visited_share";
inline constexpr std::string_view said_last = "last_words";

struct Race;
struct ContestResult;
struct Standing;

/// What a world knows of a maze before any contest.
struct MazeFacts {
  /// The best possible score; nothing where no mouse can score, and then the maze counts nowhere.
  std::optional<double> bound;
  /// The fastest possible run, in the unit of the world's fields; nothing where none leads to a goal.
  std::optional<double> best_run;
  /// The cells that a mouse can reach: shares of discovered and visited cells are of these.
  CellSet reachable;
  /// False where a race was stopped before it asked; then nothing is known.
  bool found = true;
};

/// What is to be kept of a contest, besides its result.
struct Keep {
  bool record = false;
  bool picture = false;
  bool reasons = false;  ///< whether the record has the reasons of decisions, if the mouse gives any
};

/// What a contest gives besides its result.
struct ContestOutput {
  std::optional<RunRecord> run;  ///< step by step, in worlds of steps
  std::string record;            ///< the text of its file, where it was to be kept
  std::string picture;           ///< SVG, where it was to be kept
};

/// A field of JSON or CSV: its name, and what stands there.
struct ContestField {
  std::string_view key;
  Value (*of)(const Race&, const ContestResult&);
  bool by_clock = false;  ///< whether it depends on a time by the machine's clock
};
struct MouseField {
  std::string_view key;
  Value (*of)(const Race&, const Standing&);
};
struct MazeField {
  std::string_view key;
  Value (*of)(const Race&, std::size_t maze);
};

/// A column of the leaderboard: two lines of heading, its width in characters, and its text in the line of a mouse. The
/// page shows those with a key, with the same heading in one line.
struct Column {
  std::string_view first, second;
  int width = 0;
  std::string (*text)(const Race&, const Standing&);
  std::string_view key = {};  ///< the field of a mouse in JSON that the page shows: a number, or both ends of a range
  std::string_view meaning = {};  ///< a sentence
  int digits = 0;                 ///< decimals on the page
  bool higher_is_better = false;
  double factor = 1.0;   ///< by which the page multiplies the field: 100 makes a share a percentage
  bool rare = false;     ///< only printed with `--columns all`
  bool in_unit = false;  ///< whether the unit of the world is the second line of its heading
};

/// A figure that studies compare besides the score: a positive number whose ratio between two mice is meaningful. It
/// has a key in the JSON of a contest, and a name in tables.
struct ComparedFigure {
  std::string_view key;
  std::string_view name;
};

/// Lists, one behind the other.
template <class Item, std::size_t... Sizes>
constexpr auto joined(const std::array<Item, Sizes>&... lists) {
  std::array<Item, (Sizes + ...)> all = {};
  auto end = all.begin();
  ((end = std::copy(lists.begin(), lists.end(), end)), ...);
  return all;
}

/// All lists in the order in which they are shown.
struct WorldFields {
  std::span<const ContestField> contest;  ///< of a result in JSON
  std::span<const ContestField> csv;      ///< of a line of CSV
  std::span<const MouseField> mouse;      ///< of a mouse in JSON, before its results
  std::span<const MazeField> maze;        ///< of a maze in JSON
  std::span<const Column> columns;
  StoredFigures figures;
  std::span<const ComparedFigure> compared = {};
  std::string_view bound = "bound";  ///< the field of a maze with its best possible score, in the unit of ScorePlace
  std::string_view bound_meaning = "best possible score";
};

/// Something that results depend on besides mice, mazes and seed: the budget, the robot. A bool, a number, a text or
/// JSON.
struct Condition {
  std::string key;
  Value value;
};

/// The conditions by a table of settings.
template <class Rows, class Conditions>
std::vector<Condition> conditions_of(const Rows& rows, const Conditions& conditions) {
  std::vector<Condition> all;
  for (const auto& [setting, of, set] : rows) all.push_back({key_of(setting), of(conditions)});
  return all;
}

/// Where the score of a contest stands in the JSON of its result, as this world writes it.
struct ScorePlace {
  std::string_view key = "score";
  std::string_view inner;                                 ///< where the score is an object, its field
  double unit = 1.0;                                      ///< factor from the number in JSON to the world's unit
  double least = 0.0;                                     ///< no score is below
  double most = std::numeric_limits<double>::infinity();  ///< no score is above
};

/// What is known of a world without a contest.
struct WorldTraits {
  std::string_view name;  ///< as in --world and in JSON
  /// Increase it when a change gives the same contest another result or other figures: contests of earlier editions in
  /// stores are then run again.
  int edition = 1;
  std::string formula = {};  ///< how it scores, in one line without its end
  std::vector<Condition> conditions = {};
  const WorldFields* fields = nullptr;  ///< never null
  bool is_unnamed = false;              ///< whether headings leave out its name
  std::string heading = {};             ///< what the heading of the leaderboard ends with, such as ", budget 500"
  /// Where its contests start and end, whatever a maze says: "starts at (0,0) ..."; empty where they keep to the maze.
  std::string_view fixed_places = {};
  /// The rules of contests that are one run in steps each; nothing in other worlds.
  std::optional<Rules> rules_in_steps = {};
  bool is_stochastic = false;  ///< whether contests depend on their seeds even if the mouse is deterministic
  bool numbers_runs = true;    ///< whether a mouse may have several contests in a maze; then their files are numbered
  std::string_view unit = {};  ///< of scores, for axes
  ScorePlace score_place = {};
  bool has_ratio = true;  ///< whether the ratio of a score to the best possible one means anything
  /// What a contest without a score counts in means over all; nothing where it has no place there.
  std::optional<double> failure_score = {};
  /// What a contest without a score counts where mice are compared, where it always has to count: the score at the time
  /// limit (PAR-1), or the failure score.
  double limit_score = 0.0;
  /// The figure that breaks ties between mice with equal mean scores, by its mean over finished contests; may be empty.
  std::string_view tie_breaker = {};
  /// What a maze without a bound is like, behind "1 maze".
  std::string_view why_no_bound = "whose goal cannot be reached";
};

class World {
 public:
  explicit World(WorldTraits traits) : traits_(std::move(traits)) {}
  virtual ~World() = default;

  const WorldTraits& traits() const { return traits_; }
  /// What the heading of the leaderboard begins with, such as "world mms, ".
  std::string title() const { return traits_.is_unnamed ? "" : fmt::format("world {}, ", traits_.name); }

  /// Why a mouse cannot enter; empty where it can.
  virtual std::string refuse(const Contestant& mouse) const = 0;
  /// Why it holds no contests in a maze, whatever mice; empty where it does.
  virtual std::string refuse(const Maze&) const { return ""; }
  /// The parameters of a mouse that count here.
  virtual Settings settings(const Contestant& mouse) const { return mouse.settings; }
  virtual MazeFacts facts(const Maze& maze) const = 0;
  /// Runs the contest of `result.mouse` in `result.maze` with `result.seed`, and fills in what is left of the result.
  /// It is not done where `stop`, which may be null, ended it. Called from several threads at once.
  virtual ContestOutput hold(const Race& race, ContestResult& result, Keep keep,
                             const std::atomic<bool>* stop) const = 0;
  /// Below the leaderboard, in lines: what the score means; and, below the failures, what else a reader has to know.
  virtual std::string notes(const Race& race) const = 0;
  virtual std::string remarks(const Race&) const { return ""; }

 private:
  WorldTraits traits_;
};

/// The second line of the heading of a column.
inline std::string_view second_line_of(const Column& column, const World& world) {
  return column.in_unit ? world.traits().unit : column.second;
}

}  // namespace labmouse
