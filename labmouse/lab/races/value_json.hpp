// Values and conditions of worlds as JSON.
#pragma once

#include "labmouse/lab/races/world.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// Null where there is no value.
Json json_of(const Value& value);

/// An object of WorldTraits::conditions, from which restore_world() makes the world again.
Json conditions_json(const World& world);

}  // namespace labmouse
