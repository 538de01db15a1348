#include "labmouse/lab/robots/remarked_robot.hpp"

#include "labmouse/lab/robots/robot_text.hpp"
#include "labmouse/lab/text/numbers.hpp"

namespace labmouse {

std::string remarked_robot(const Robot& robot, RobotParts parts, const KeyRemarks& remarks,
                           const std::string& otherwise) {
  Json parameters = robot_json(robot, parts)["parameters"];
  // What was divided by its unit and multiplied again is the number that it was.
  for (auto& value : parameters)
    if (value.is_number_float()) value = rounded(value.get<double>(), 12);
  if (!robot.fixed) {
    parameters["curve.speeds"] = robot.speeds;
    parameters["stop"] = robot.stop == Stop::goal ? "goal" : "beyond";
  }
  return robot_text(ReadJson::parse(parameters.dump()), [&](std::string_view key) {
    const auto remark = remarks.find(key);
    return remark == remarks.end() ? otherwise : remark->second;
  });
}

}  // namespace labmouse
