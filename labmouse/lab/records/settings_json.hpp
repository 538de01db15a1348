// Parameters of a mouse as a JSON object.
#pragma once

#include "labmouse/lab/text/json.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// Name to value. Numbers stand as numbers, everything else as in a SPEC.
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
