// The world that a call of the page asks for.
#pragma once

#include <memory>

#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/races/world.hpp"
#include "labmouse/lab/replays/replay.hpp"

namespace labmouse {

/// `world`, by its name (the first one where it is missing), with those of its settings that the request has; null
/// where it is refused. A page reads no files: a setting that names one is refused, and a text that would be in one can
/// be given below its name.
std::shared_ptr<const World> read_page_world(PageRequest& request);

/// `again` of a play: what `contest` is asked so that other mice have the same contest, and which built-in mice can.
Json again_json(const World& world);

/// The play of a record that was opened, with `again` where other mice can have its contest.
Json play_of(const Replay& replay);

}  // namespace labmouse
