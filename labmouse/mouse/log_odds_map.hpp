// A log-odds map: the odds of each wall to be closed, and the known walls that follow from them.
//
// Each wall has the logarithm of its odds to be closed, in eighths of a nat, and readings add to it. Knowledge is a
// view of these: the first reading decides, and once others have turned the odds well to the other side the wall turns
// over. As long as none does the view only grows, which is what strategies rely on; when one does, a new version of the
// view begins, at which they plan anew. A learned map begins at odds counted in other mazes, by what is known of the
// eight walls about that one as it is first read; in mazes too small for these, at even ones.
//
//      open ◄───────┬───────────────┬───────► closed
//    -64           -16      0      +16           +64
//                    a wall turns over beyond these
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "labmouse/grid/cell_set.hpp"
#include "labmouse/mouse/evidence.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/wall_prior.hpp"

namespace labmouse {

/// What a map does with readings against what it has taken a wall for.
enum class MapKind : std::uint8_t {
  first,     ///< nothing: the first reading stays for ever, as in most mice
  log_odds,  ///< it weighs them
  learned,   ///< it weighs them with what other mazes say, and asks whether it is where it believes to be
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
  /// Two or three readings to the contrary turn a wall over of which nothing more could be surer.
  static constexpr int most = 8 * evidence_a_nat;
  /// What is beyond that says something.
  static constexpr int telling = 2 * evidence_a_nat;

  /// What a reading has done.
  enum class News : std::uint8_t {
    none,          ///< nothing that was not known
    learned,       ///< the wall was unknown
    contradicted,  ///< it speaks against what the wall is taken for, and is not enough
    turned,        ///< the wall is taken for the opposite now
  };

  /// Of a mouse that sees one cell far and knows the border.
  LogOddsMap(Size size, MapKind kind);

  /// Takes in a reading of a wall. Of a wall that was unknown 0 says that it is open, or what other mazes say.
  News add(Wall wall, int evidence);
  /// Counts a reading that it took in by half. What spoke for the wall's state is never taken for less than nothing.
  void weaken(Wall wall, int evidence);
  /// Makes an inner wall unknown.
  void forget(Wall wall);
  /// Forgets the walls taken for closed on that way between cells on which the odds against it are least in all.
  /// Whether there is a way, and a wall on it.
  bool weaken_path(Cell from, const CellSet& to);

  /// Above 0 where it is rather closed; `most` of the border.
  int odds(Wall wall) const;
  const Knowledge& view() const { return view_; }
  /// What the view says of the walls around a pose, as a reading of one cell.
  Sighting sighting(const Pose& pose) const;
  /// Grows with each view that does not contain the one before.
  int version() const { return version_; }

 private:
  std::size_t index_of(Wall wall) const;
  /// The odds of a wall that nobody has read.
  int expected(Wall wall) const;

  Size size_;
  MapKind kind_;
  const WallPrior* prior_;         ///< or null
  std::vector<std::int8_t> odds_;  ///< of the north and the east side of each cell
  Knowledge view_;
  int version_ = 0;
  // For weaken_path(): what it takes to come to each cell, and in which heading it is entered then.
  std::vector<int> costs_;
  std::vector<Heading> entered_;
};

}  // namespace labmouse
