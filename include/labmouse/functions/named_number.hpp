// A number that users may choose by a name.
#pragma once

#include <string_view>

namespace labmouse {

struct NamedNumber {
  std::string_view name;
  double number = 0.0;
};

}  // namespace labmouse
