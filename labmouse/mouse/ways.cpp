#include "labmouse/mouse/ways.hpp"

#include "labmouse/mouse/drive/drive_fields.hpp"

namespace labmouse {

SearchWays::SearchWays(const Briefing& briefing) : field_(briefing.drive.fields->ways()) {}

Action SearchWays::step_towards(const CellSet& cells, const Knowledge& knowledge, const SearchPlace& place) {
  field_.fill(knowledge.possible(), knowledge.known_cells(), cells, &place);
  return hopeful_step(field_, knowledge, place);
}

Action hopeful_step(const SearchField& field, const Knowledge& knowledge, const SearchPlace& place) {
  const Action step = field.step(place);
  if (step.kind != Action::Kind::step || step.movement == 0) return step;
  const Heading direction = after_search(place, step).pose.heading;
  if (knowledge.open().contains(wall_at(place.pose.cell, direction))) return step;
  // If readings are certain, only the wall behind a mouse at rest can be unknown: the other three were just read. If
  // they are not, the mouse stops and looks that way.
  return step.rotation == 180 || (place.at_rest && step.rotation == 0) ? Action::step(90, 0)
                                                                       : Action::step(step.rotation, 0);
}

CellSet viewpoints_of(const WallSet& walls, const Knowledge& knowledge, int sight) {
  CellSet cells;
  walls.for_each([&](Wall wall) {
    for (const Heading direction : {wall.side, opposite(wall.side)}) {
      Cell cell = direction == wall.side ? wall.cell : neighbour(wall.cell, wall.side);
      cells.insert(cell);
      for (int away = 1; away < sight && knowledge.open().contains(wall_at(cell, opposite(direction))); ++away) {
        cell = neighbour(cell, opposite(direction));
        cells.insert(cell);
      }
    }
  });
  return cells;
}

}  // namespace labmouse
