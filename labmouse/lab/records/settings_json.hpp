// Parameters of a mouse as a JSON object.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "labmouse/lab/text/json.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// Maps each name to its value: numbers as numbers, all else as text as in a SPEC.
inline Json settings_json(const Settings& settings) {
  auto json = Json::object();
  for (const Setting& setting : settings.all()) {
    const std::optional<double> number = parse_plain_number(setting.value);
    if (!number)
      json[setting.name] = setting.value;
    else if (std::abs(*number) <= 1e15 && *number == std::floor(*number))
      json[setting.name] = static_cast<std::int64_t>(*number);
    else
      json[setting.name] = *number;
  }
  return json;
}

}  // namespace labmouse
