// Whether JSON has a shape.
#pragma once

#include <string>

#include "labmouse/lab/shapes/shape.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse::test {

/// The first place that is not of that shape and why, as "mice[3].name is missing"; empty where there is none. Fields
/// that the shape does not have are wrong, too.
std::string mismatch(const ReadJson& json, const Shape& shape, const std::string& path = "it");

}  // namespace labmouse::test
