#include "labmouse/lab/races/value_json.hpp"

#include <type_traits>
#include <variant>

namespace labmouse {

Json json_of(const Value& value) {
  return std::visit(
      [](const auto& held) -> Json {
        using ContestOutput = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<ContestOutput, std::monostate>)
          return nullptr;
        else if constexpr (std::is_same_v<ContestOutput, JsonText>)
          return Json::parse(held.text);
        else
          return held;
      },
      value);
}

Json conditions_json(const World& world) {
  Json json = Json::object();
  for (const Condition& condition : world.traits().conditions) json[condition.key] = json_of(condition.value);
  return json;
}

}  // namespace labmouse
