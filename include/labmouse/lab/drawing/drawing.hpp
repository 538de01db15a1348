// Mazes and walks as pictures: SVG for documents, text for terminals.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/contest/coverage.hpp"
#include "labmouse/contest/record.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The walk of a search run in its two legs, as poses from first to last, one a step.
struct SearchLegs {
  /// From the start to the first step that ends in a goal; all of the walk where none does.
  std::vector<Pose> to_goal;
  /// From there to the reset, or to the end of the record; empty where no goal was entered.
  std::vector<Pose> onwards;
};

/// What to draw over the walls. Texts may come from untrusted sources: both drawings escape them.
struct DrawingLayers {
  bool coordinates = false;  ///< numbers of columns and rows, from 0
  /// A text for each cell (a distance, a count), empty for none.
  std::function<std::string(Cell)> label;
  /// What the labels are, with their unit, for the legend of the SVG: "steps to the goal".
  std::string label_meaning;
  /// The poses of a walk, one per step: drawn as a line with a numbered dot at the end of each step. The line is
  /// interrupted where no open straight way leads to the next pose (the mouse was carried to the start).
  std::vector<Pose> route;
  /// How often each cell was visited: drawn as heat (in text only with colours).
  std::function<int(Cell)> visits;
  /// The background of each cell as one of the 256 terminal colours; 0 for none (only in text with colours).
  std::function<int(Cell)> paint;
  /// Walls that the mouse does not know: drawn faintly, open or not.
  std::optional<WallSet> unknown;
  /// Closed walls that the mouse assumes open: drawn in a colour of their own.
  std::optional<WallSet> wrong;
  /// Open walls that a map has as closed: drawn in a third colour. With them, `wrong` are the walls that the map
  /// missed.
  std::optional<WallSet> false_walls;
  /// The search run as two lines beside each other, in two colours.
  std::optional<SearchLegs> search_run;
  /// The cells that a search run visited and those that it discovered, shaded in two tones (in text only the shares).
  std::optional<ExploredCells> explored;
  /// The walls that the mouse considered to explore next: dashed lines with the costs of their runs in steps. The
  /// chosen one is solid and thicker; those not worth the way are half transparent (not in text).
  std::optional<StepReasons> candidates;
  /// Where the mouse stands now.
  std::optional<Pose> mouse;
  std::string title;  ///< empty: none
};

/// Draws a maze as an SVG picture with a legend and a description for screen readers. Its colours suit colour-blind
/// eyes, and a light or a dark background.
/// @param maze the walls, the start and the goals.
/// @param layers what to draw over them; its cells and walls must lie in the maze.
/// @return the content of a self-contained SVG file.
std::string draw_svg(const Maze& maze, const DrawingLayers& layers);

/// Draws a maze as lines of text: posts `o`, walls `---` and `|`, unknown walls `- -` and `:`, wrong guesses `###` and
/// `#`, false walls `%%%` and `%`, the route as dots with the number of each step where it ends, the search run as `+`
/// to the goal, `x` from there on and `*` where both went, the mouse as one of `^ > v <`. A cell is three columns wide;
/// longer labels end in `~`. Below stand the meanings of the signs for wrong guesses, false walls and the search run,
/// and the shares of the explored cells. Only labels and title may be other than ASCII.
/// @param maze the walls, the start `S` and the goals `G`.
/// @param layers what to draw over them; its cells and walls must lie in the maze.
/// @param colours whether to add ANSI colours, for a terminal.
/// @return lines that end in a line feed.
std::string draw_text(const Maze& maze, const DrawingLayers& layers, bool colours);

/// draw_text() with the colours already chosen, for callers that do not know whether there is a terminal.
using TextDrawer = std::function<std::string(const Maze&, const DrawingLayers&)>;
/// Makes such a function.
/// @param colours whether its drawings have ANSI colours.
/// @return never empty.
TextDrawer text_drawer(bool colours);

}  // namespace labmouse
