#include "labmouse/lab/mice/mice_json.hpp"

#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

std::string_view name_of(ParameterScope scope) {
  if (scope == ParameterScope::errors) return "errors";
  return scope == ParameterScope::steps ? "steps" : "seconds";
}

/// Adds `counts_in` if the parameter has no effect in some world in which its mouse races.
Json parameter_json(const Parameter& parameter, bool plays_in_both) {
  Json json = {{"name", parameter.name},
               {"type", name_of(parameter.type)},
               {"default", parameter.default_value},
               {"meaning", parameter.meaning}};
  if (parameter.scope == ParameterScope::errors || (plays_in_both && parameter.scope != ParameterScope::both))
    json["counts_in"] = name_of(parameter.scope);
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
  for (const BuiltinMouse* mouse : all_mice()) {
    Json parameters = Json::array();
    for (const Parameter& parameter : mouse->parameters)
      parameters.push_back(parameter_json(parameter, mouse->walks() && mouse->drives()));
    mice.push_back({{"name", mouse->name},
                    {"summary", mouse->summary},
                    {"is_stochastic", mouse->uses_chance(Settings(mouse->parameters))},
                    {"walks", mouse->walks()},
                    {"drives", mouse->drives()},
                    {"parameters", std::move(parameters)},
                    {"method", mouse->method},
                    {"source", mouse->source}});
  }
  return mice;
}

}  // namespace labmouse
