// A number that users may choose by a name.
#pragma once

#include <string_view>

namespace labmouse {

/// A number and its name, in static memory.
struct NamedNumber {
  std::string_view name;
  double number = 0.0;
};

}  // namespace labmouse
