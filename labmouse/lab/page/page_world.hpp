// Reads the world of a request.
#pragma once

#include <string_view>

#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/races/world.hpp"
#include "labmouse/lab/replays/replay.hpp"
#include "labmouse/lab/worlds/entering.hpp"

namespace labmouse {

/// In place of a value of a setting whose default depends on the size of the mazes: that default.
inline constexpr std::string_view by_maze_size = "by-size";

/// The world of the field `world` (default: the first world), with the settings in the request; null if it is refused.
/// Settings cannot name files. In place of a file, a setting gives a name, a line break and the file's text. The
/// defaults are those of classic mazes: see suit_defaults.
Entry read_page_world(PageRequest& request);

/// The field `again` of a play (the JSON of a contest that the page replays): the fields of a `contest` request that
/// repeat its conditions, and the built-in mice that can race under them.
Json again_json(const World& world);

/// The play of a record, with `again` if its conditions can be restored.
Json play_of(const Replay& replay);

}  // namespace labmouse
