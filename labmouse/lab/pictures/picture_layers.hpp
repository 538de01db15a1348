// The layers of pictures by their names, made from a maze or from a record.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/records/record_file.hpp"

namespace labmouse {

enum class Layer : std::uint8_t {
  heat,         ///< how often the search run entered each cell
  path,         ///< the speed run, step by step; for a maze without record, a shortest run
  search_run,   ///< the way of the search run: to the goal, and from there to the reset
  known,        ///< walls that the mouse did not know at the end of the search run, faint
  wrong,        ///< closed walls among them, which an optimistic mouse assumes open
  shares,       ///< the cells visited and discovered, and their shares of all that can be reached
  distances,    ///< steps to the goal in each cell
  cells,        ///< cells to walk to the goal from each cell
  coordinates,  ///< the numbers of columns and rows
  candidates,   ///< the unseen walls of the mouse's last choice, for a record with reasons
};

using LayerSet = std::set<Layer>;

std::string_view name_of(Layer layer);
/// One line about a layer, for lists.
std::string_view meaning_of(Layer layer);
/// All layers, in the order of their names above.
const LayerSet& all_layers();
/// Whether the layer needs a record.
bool needs_record(Layer layer);
/// Whether text drawings cannot show it in the maze (of `shares` they print the figures only); heat needs colours.
bool needs_svg(Layer layer, bool colours);

/// The layers of a list such as `heat,path`, or an error text.
struct LayersResult {
  LayerSet layers;
  std::string error;
};
LayersResult read_layers(std::string_view names);

/// The layers of a maze without record; those that need one stay empty.
DrawingLayers layers_of(const Maze& maze, const Rules& rules, const LayerSet& chosen);

/// The layers of a record that has a maze and agrees with it. A record that was cut, or without a reset, is drawn to
/// its end as a search run.
DrawingLayers layers_of(const RecordFile& file, const LayerSet& chosen);

/// The record cut after that step (1 or more), so that the layers show what was known and chosen by then.
RecordFile as_of(RecordFile file, int step);

/// The layers of the default picture of a contest: the speed run over the visits of the search run.
const LayerSet& contest_layers();

}  // namespace labmouse
