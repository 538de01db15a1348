// JSON in the lab: which of the library's types is which.
#pragma once

#include <nlohmann/json.hpp>

namespace labmouse {

/// JSON that is written: the fields of an object stay in the order in which they were added.
using Json = nlohmann::ordered_json;
/// JSON that was read: a field is found in a time that grows with the logarithm of their number, which a hostile file
/// chooses.
using ReadJson = nlohmann::json;

}  // namespace labmouse
