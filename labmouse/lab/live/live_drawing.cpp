#include "labmouse/lab/live/live_drawing.hpp"

#include <fmt/format.h>

#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/map_comparison.hpp"

namespace labmouse {

std::string draw_live(const LiveMap& map, bool colours) {
  const PartialMap seen = map.map();
  DrawingLayers layers;
  layers.coordinates = true;
  layers.mouse = map.pose();
  layers.route = map.route();
  layers.unknown = seen.unseen;
  if (!map.truth()) return draw_text(seen.known, layers, colours);
  const auto compared = compare_maps(seen.known, seen.unseen, *map.truth());
  layers.wrong = compared->missed_walls;
  layers.false_walls = compared->false_walls;
  return draw_text(*map.truth(), layers, colours);
}

std::string live_summary(const LiveMap& map, const LiveReader& reader) {
  const PartialMap seen = map.map();
  const int walls = WallSet::all(seen.known.size()).count();
  std::string text = fmt::format("{} of {} inner walls seen from {}; {}, {}; {}, {} of noise\n",
                                 walls - seen.unseen.count(), walls, counted(map.cells().count(), "cell", "cells"),
                                 counted(map.contradictions().size(), "contradiction", "contradictions"),
                                 counted(map.restarts(), "restart", "restarts"),
                                 counted(reader.lines(), "line", "lines"), reader.noise());
  std::string fields;
  for (const auto& [name, value] : map.fields())
    fields += fmt::format("{}{}={}", fields.empty() ? "" : " ", name, value);
  return text + shown(fields) + "\n";
}

}  // namespace labmouse
