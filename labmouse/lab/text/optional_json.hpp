// JSON of optional values.
#pragma once

#include <optional>

#include "labmouse/lab/text/json.hpp"

namespace labmouse {

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace labmouse
