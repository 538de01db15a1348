// Parameters of a mouse as a JSON object.
#pragma once

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
    else if (*number == static_cast<double>(static_cast<long>(*number)))
      json[setting.name] = static_cast<long>(*number);
    else
      json[setting.name] = *number;
  }
  return json;
}

}  // namespace labmouse
