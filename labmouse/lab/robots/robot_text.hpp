// Writes robot files, and reads the values in one.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// The text of a file with those values, by the names of their keys, in the order of robot_keys(). Each line has its
/// unit and its remark, if there are any.
std::string robot_text(
    const ReadJson& values,
    const std::function<std::string(std::string_view key)>& remark = [](std::string_view) { return std::string(); });

/// The values of all known keys in a file that are numbers, booleans or texts, even wrong ones. Empty for invalid TOML.
Json robot_values(std::string_view text);

}  // namespace labmouse
