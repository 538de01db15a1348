// The map of a real robot as its lines arrive, and what contradicts in them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/grid/cell_set.hpp"
#include "labmouse/grid/wall_set.hpp"
#include "labmouse/lab/live/live_line.hpp"
#include "labmouse/maze/formats/read_result.hpp"

namespace labmouse {

/// One side of a cell as the robot saw it.
struct WallReading {
  Cell cell;  ///< where the robot was
  Heading side = Heading::north;
  bool closed = false;
  std::int64_t line = 0;  ///< its number
  bool is_drawn = false;  ///< of a drawing, which does not say where the robot was; `cell` is then one beside the wall

  friend bool operator==(const WallReading&, const WallReading&) = default;
};

/// What a user should know of a line.
struct LiveFinding {
  enum class Kind : std::uint8_t {
    restart,        ///< the robot has started anew
    outside,        ///< the cell lies outside of the maze
    open_border,    ///< a wall of the border was seen as open
    contradiction,  ///< a wall was seen in another state before
    false_wall,     ///< seen as closed, open in the known maze
    missed_wall,    ///< seen as open, closed in the known maze
  };

  Kind kind = Kind::restart;
  std::int64_t line = 0;
  std::optional<Cell> cell = {};           ///< of the robot; nothing where a restart does not say it
  std::optional<WallReading> now = {};     ///< of a wall, in the last four kinds
  std::optional<WallReading> before = {};  ///< of a contradiction

  friend bool operator==(const LiveFinding&, const LiveFinding&) = default;
};

/// The finding in words, in which a wall is a side of the cell from which it was seen: "line 7: the wall east of (3,4)
/// is closed, but open in line 2, seen from (4,4)".
std::string words_of(const LiveFinding& finding);

/// What a real robot knows of its maze. The newest reading of a wall counts. The border is closed. A restart keeps the
/// map, because the maze is the same.
class LiveMap {
 public:
  /// A map of a maze that nobody knows.
  explicit LiveMap(Size size);
  /// A map of a maze that is known: wrong readings are findings.
  explicit LiveMap(const Maze& truth);

  /// Adds what a line says. If the robot is in the start cell, and was in no neighbour of it before, it was carried
  /// there: a restart.
  /// @return what the user should know, by heading. A reading that repeats the newest one of its wall is not repeated.
  std::vector<LiveFinding> add(const LiveLine& line);

  /// The map; `unseen` is empty once all inner walls were seen. Start and goals are those of the known maze, if there
  /// is one.
  PartialMap map() const;
  /// The readings of walls that were seen in both states: the newest of each, and the newest that contradicts it.
  std::vector<LiveFinding> contradictions() const;
  /// The walls whose newest reading differs from the known maze; none without one.
  std::vector<LiveFinding> wrong_walls() const;

  /// Where the robot is; nothing before the first line with a cell, and after a restart.
  const std::optional<Pose>& pose() const { return pose_; }
  /// The route that the robot plans, from its pose: the cells where it turns, and the last one. Ends at the border.
  std::vector<Pose> route() const;
  /// The newest value of each field, by name. At most `most_fields` names are kept.
  const std::map<std::string, std::string>& fields() const { return fields_; }
  static constexpr std::size_t most_fields = 32;

  /// The known maze, or nothing.
  const std::optional<Maze>& truth() const { return truth_; }
  int restarts() const { return restarts_; }
  /// The cells from which the robot reported walls.
  const CellSet& cells() const { return cells_; }

 private:
  struct Readings {
    WallReading newest;
    std::optional<WallReading> contradicting;  ///< the newest of the other state
  };

  void add_restart(const LiveLine& line, std::vector<LiveFinding>& findings);
  void add_cell(const LiveLine& line, const SeenCell& seen, std::vector<LiveFinding>& findings);
  void add_drawing(const PartialMap& drawing, std::int64_t line, std::vector<LiveFinding>& findings);
  void add_wall(const WallReading& reading, std::vector<LiveFinding>& findings);
  bool is_wrong(const WallReading& reading) const;

  Size size_;
  std::optional<Maze> truth_;
  Cell start_;
  std::map<Wall, Readings> walls_;
  std::optional<Pose> pose_;
  std::map<std::string, std::string> fields_;
  CellSet cells_;
  int restarts_ = 0;
};

}  // namespace labmouse
