// The text of a robot file, and the values in one.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// A file with those values, by the names of their keys, in the order of robot_keys(): in sections, each line with its
/// unit and its remark, where there are any.
std::string robot_text(
    const ReadJson& values,
    const std::function<std::string(std::string_view key)>& remark = [](std::string_view) { return std::string(); });

/// The values of all keys that stand in a file, right or wrong, as long as they are numbers, truths or texts; none of a
/// text that is no TOML.
Json robot_values(std::string_view text);

}  // namespace labmouse
