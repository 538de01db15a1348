// Reads the robot of a request.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/page/request.hpp"

namespace labmouse {

/// The text of its robot file: of a built-in robot (field `built_in`), made of the field `values`, or else `bytes`.
std::string robot_text_of(PageRequest& request, std::string_view bytes);

}  // namespace labmouse
