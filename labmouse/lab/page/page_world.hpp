// The world that a call of the page asks for.
#pragma once

#include <memory>

#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/races/world.hpp"

namespace labmouse {

/// `world`, by its name (the home world where it is missing), with those of its settings that the request has; null
/// where it is refused. A page reads no files: a setting that names one is
/// refused, and a text that would be in one can be given below its name.
std::shared_ptr<const World> read_page_world(PageRequest& request);

}  // namespace labmouse
