#include "labmouse/lab/mice/mice_json.hpp"

#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

Json parameter_json(const Parameter& parameter) {
  Json json = {{"name", parameter.name},
               {"type", name_of(parameter.type)},
               {"default", parameter.default_value},
               {"meaning", parameter.meaning}};
  switch (parameter.type) {
    case ParameterType::flag:
      break;
    case ParameterType::choice:
    case ParameterType::prior:
      json["choices"] = choices_of(parameter);
      break;
    default:
      json["low"] = parameter.low, json["high"] = parameter.high;
  }
  return json;
}

}  // namespace

Json mice_json() {
  Json mice = Json::array();
  for (const RosterEntry* mouse : all_mice()) {
    Json parameters = Json::array();
    for (const Parameter& parameter : mouse->parameters) parameters.push_back(parameter_json(parameter));
    mice.push_back({{"name", mouse->name},
                    {"summary", mouse->summary},
                    {"throws_dice", mouse->uses_chance(Settings(mouse->parameters))},
                    {"walks", mouse->walks},
                    {"drives", mouse->drives},
                    {"parameters", std::move(parameters)},
                    {"method", mouse->method},
                    {"source", mouse->source}});
  }
  return mice;
}

}  // namespace labmouse
