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

inline constexpr std::array all_map_kinds = {MapKind::first, MapKind::log_odds, MapKind::learned};

constexpr std::string_view name_of(MapKind kind) {
  return kind == MapKind::first ? "first" : kind == MapKind::log_odds ? "log-odds" : "log-odds-prior";
}

/// The kind of that name, or nothing.
constexpr std::optional<MapKind> map_kind_of(std::string_view name) {
  for (const MapKind kind : all_map_kinds)
    if (name_of(kind) == name) return kind;
  return std::nullopt;
}

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

  /// For a mouse that sees one cell far and knows the border.
  LogOddsMap(Size size, MapKind kind);

  /// Adds the evidence of a reading. An unknown wall starts at its prior odds (0 without a prior), and is open if the
  /// sum is 0 or less.
  News add(Wall wall, int evidence);
  /// Takes back half of a reading that was added. This never moves the odds past 0, against the wall's state.
  void weaken(Wall wall, int evidence);
  /// Makes an inner wall unknown.
  void forget(Wall wall);
  /// Finds the path between the cells with the least sum of odds + `most` (at least 1) over its closed walls, and makes
  /// these walls unknown: few walls, and uncertain ones. False if there is no path, or no closed wall on it.
  bool weaken_path(Cell from, const CellSet& to);

  /// Log-odds in eighths of a nat, above 0 if the wall is more likely closed; `most` for the border.
  int odds(Wall wall) const;
  const Knowledge& view() const { return view_; }
  /// The walls around a pose as a reading of one cell; unknown ones count as closed.
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
