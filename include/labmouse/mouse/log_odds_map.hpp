// A log-odds map: the odds of each wall to be closed, and the known walls that follow from them.
//
// Each wall has the logarithm of its odds to be closed, in eighths of a nat, and readings add to it. Knowledge is a
// view of these odds: the first reading of a wall decides, and the wall changes its state once later readings bring the
// odds to the opposite threshold. As long as no wall changes, the view only grows, which strategies rely on. A change
// begins a new version of the view, at which they plan anew. The kind `learned` starts each wall at prior odds in place
// of even ones. They were counted in other mazes, by the states (unknown, open or closed) of the eight walls around it
// at its first reading. Small mazes have no prior.
//
//      open ◄───────┬───────────────┬───────► closed
//    -64           -16      0      +16           +64
//                    a wall changes its state at these
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "labmouse/grid/cell_set.hpp"
#include "labmouse/mouse/evidence.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

struct WallPrior;

/// How a map handles readings that contradict the state of a wall.
enum class MapKind : std::uint8_t {
  first,     ///< it ignores them: the first reading stays for ever, as in most mice
  log_odds,  ///< it adds up the evidence
  learned,   ///< the same with prior odds from other mazes; too many contradictions mean a lost position
};

/// All kinds, in the order of the enumeration.
inline constexpr std::array all_map_kinds = {MapKind::first, MapKind::log_odds, MapKind::learned};

/// The name of a kind in options and records.
/// @param kind one of all_map_kinds.
/// @return "first", "log-odds" or "log-odds-prior"; in static memory.
constexpr std::string_view name_of(MapKind kind) {
  return kind == MapKind::first ? "first" : kind == MapKind::log_odds ? "log-odds" : "log-odds-prior";
}

/// The kind of a name.
/// @param name "first", "log-odds" or "log-odds-prior".
/// @return nullopt for any other name.
constexpr std::optional<MapKind> map_kind_of(std::string_view name) {
  for (const MapKind kind : all_map_kinds)
    if (name_of(kind) == name) return kind;
  return std::nullopt;
}

/// The log-odds of all walls of one maze, and the known walls that follow from them. Log-odds and evidence are in
/// eighths of a nat. Takes all its memory when made.
class LogOddsMap {
 public:
  /// Limit of the odds, so that two or three contradicting readings change even the surest wall.
  static constexpr int most = 8 * evidence_a_nat;
  /// Evidence of this size contradicts, and opposite odds of this size change a wall's state.
  static constexpr int telling = 2 * evidence_a_nat;

  /// The effect of a reading.
  enum class News : std::uint8_t {
    none,          ///< nothing new
    learned,       ///< the wall was unknown
    contradicted,  ///< it contradicts the wall's state, but does not change it
    turned,        ///< the wall has changed its state
  };

  /// All inner walls unknown. The mouse sees one cell far and knows the border.
  /// @param size of the maze, with sides of 1 to max_side cells.
  /// @param kind how contradicting readings are handled. For `learned`, mazes with a side below 8 cells have no prior.
  LogOddsMap(Size size, MapKind kind);

  /// Adds the evidence of a reading. An unknown wall starts at its prior odds (0 without a prior), and is open if the
  /// sum is 0 or less. A map of the kind `first` leaves a known wall as it is.
  /// @param wall any of the maze; the border is left as it is.
  /// @param evidence log-likelihood ratio in eighths of a nat, above 0 for a wall. The sum is cut to -most to most.
  /// @return the effect; `none` for the border.
  News add(Wall wall, int evidence);
  /// Takes back half of a reading that was added. This never moves the odds past 0, against the wall's state. Does
  /// nothing to the border and to unknown walls.
  /// @param wall any of the maze.
  /// @param evidence that of the reading, in eighths of a nat; half of it is rounded towards 0.
  void weaken(Wall wall, int evidence);
  /// Makes a wall unknown, with log-odds of 0.
  /// @param wall any of the maze; the border is left as it is.
  void forget(Wall wall);
  /// Finds the path between the cells with the least sum of odds + `most` (at least 1) over its closed walls, and makes
  /// these walls unknown: few walls, and uncertain ones.
  /// @param from a cell inside the maze.
  /// @param to cells inside the maze.
  /// @return false, and nothing changes, if a path without closed walls leads there, or `to` is empty.
  bool weaken_path(Cell from, const CellSet& to);

  /// The log-odds of a wall.
  /// @param wall any of the maze.
  /// @return in eighths of a nat, above 0 if the wall is more likely closed; 0 if it is unknown, `most` for the border.
  int odds(Wall wall) const;
  /// The known walls that follow from the odds.
  const Knowledge& view() const { return view_; }
  /// The walls around a pose as a reading of one cell.
  /// @param pose inside the maze.
  /// @return 1 for an open wall, 0 for a closed or unknown one.
  Sighting sighting(const Pose& pose) const;
  /// Grows whenever a known wall changes or is forgotten.
  int version() const { return version_; }

 private:
  std::size_t index_of(Wall wall) const;
  /// The prior odds of a wall without readings.
  int expected(Wall wall) const;

  Size size_;
  MapKind kind_;
  const WallPrior* prior_;         ///< or null
  std::vector<std::int8_t> odds_;  ///< of the north and the east side of each cell
  Knowledge view_;
  int version_ = 0;
  // For weaken_path(): the least cost to each cell, and the heading in which it is then entered.
  std::vector<int> costs_;
  std::vector<Heading> entered_;
};

}  // namespace labmouse
