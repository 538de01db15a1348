// The robot that a request is about, while it is edited.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/page/request.hpp"

namespace labmouse {

/// The text of its file: of one that the page brings (`built_in`), with those `values`, or in the bytes beside the
/// request.
std::string robot_text_of(PageRequest& request, std::string_view bytes);

}  // namespace labmouse
