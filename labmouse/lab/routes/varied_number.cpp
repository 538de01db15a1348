#include "labmouse/lab/routes/varied_number.hpp"

#include "labmouse/lab/robots/robot_keys.hpp"

namespace labmouse {

std::string unit_of(const VariedNumber& number) {
  for (const RobotKey& key : robot_keys())
    if (key.name == number.key) return std::string(key.unit);
  return "";
}

}  // namespace labmouse
