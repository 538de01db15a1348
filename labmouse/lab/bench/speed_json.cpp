#include "labmouse/lab/bench/speed_json.hpp"

#include <string>

namespace labmouse {

Json distance_json(const DistanceSpeeds& speeds) {
  Json json;
  for (const auto& [side, ns] : speeds)
    json[std::to_string(side)] = {
        {"rows", ns.rows}, {"portable_rows", ns.portable_rows}, {"queue", ns.queue}, {"plain", ns.plain}};
  return json;
}

}  // namespace labmouse
